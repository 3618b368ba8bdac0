//! `--template`, `--paper` and `--head`: how a report for people looks.

use std::path::Path;
use std::sync::Arc;

use super::super::{CliError, IntoCliError as _};
use crate::files;
use crate::message::Say as _;
use crate::report::Report;
use crate::report::paper::Paper;
use crate::report::template::{HeadField, Template};

/// How a report for people looks.
#[derive(Debug, Clone, clap::Args)]
#[command(next_help_heading = "Pages")]
pub(super) struct TemplateArgs {
    /// Template of a report as PDF or PNG: a file, or inspection, first-article, certificate, list, statistics, sheet, label
    #[arg(long, value_name = "FILE|NAME")]
    template: Option<String>,

    /// Paper of a report as PDF or PNG; default: that of the template
    #[arg(long, value_parser = super::one_of(Paper::ALL.iter().copied(), |paper| paper.name()))]
    paper: Option<Paper>,

    /// Field of the head of a report as PDF or PNG, such as customer or revision; can be repeated
    #[arg(long = "head", value_name = "FIELD=TEXT", value_parser = head)]
    heads: Vec<(HeadField, String)>,
}

fn head(text: &str) -> Result<(HeadField, String), String> {
    let (word, text) = text.split_once('=').ok_or("expected a field, = and a text, such as customer=Northgate")?;
    let known = HeadField::ALL.iter().find(|field| field.word() == word.trim());
    let words = || HeadField::ALL.iter().map(|field| field.word()).collect::<Vec<_>>().join(", ");
    let field = known.ok_or_else(|| format!("{word} is not a field of the head: use one of {}", words()))?;
    Ok((*field, text.to_owned()))
}

impl TemplateArgs {
    /// The template that was asked for, or the usual one.
    ///
    /// # Errors
    /// It cannot be read.
    pub(super) fn template(&self) -> Result<Arc<Template>, CliError> {
        self.template.as_deref().map_or_else(|| Ok(Template::usual()), read)
    }

    /// The paper that was asked for, or that of the template.
    pub(super) fn paper(&self, template: &Template) -> Paper {
        self.paper.unwrap_or(template.paper)
    }

    /// The report by a template, on the paper and with the head that were asked for.
    pub(super) fn dress(&self, report: Report, template: &Arc<Template>) -> Report {
        let mut report = report.by(template);
        report.paper = self.paper(template);
        for (field, text) in &self.heads {
            report.tell(*field, text);
        }
        report
    }
}

/// A shipped template by its name, or one of a file.
fn read(name: &str) -> Result<Arc<Template>, CliError> {
    if let Some(shipped) = Template::shipped().iter().find(|template| template.word() == name) {
        return Ok(Arc::clone(shipped));
    }
    let path = Path::new(name);
    let bytes = files::read_file(path).said()?;
    let template = Template::read(&String::from_utf8_lossy(&bytes)).about(name)?;
    let logo = |name: &str| files::read_file(&path.with_file_name(name)).map_err(|error| error.message());
    Ok(Arc::new(template.with_logo(logo)))
}

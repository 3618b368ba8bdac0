//! The user's own templates of reports: every TOML file of the folder `templates` beside the state file, with its logo.

use std::path::Path;
use std::sync::Arc;

use crate::files;
use crate::message::{Message, Say as _, message};
use crate::report::template::Template;

/// The most files that are read.
const MOST: usize = 100;

/// Reads the templates of a folder in the order of their names; none where it does not exist.
pub(super) fn read(folder: &Path) -> Vec<Result<Arc<Template>, Message>> {
    let Ok(list) = files::list(folder) else { return Vec::new() };
    let templates = list.entries.iter().filter(|entry| !entry.is_folder && entry.ends_with(&["toml"]));
    templates.take(MOST).map(|entry| template(&entry.path)).collect()
}

fn template(path: &Path) -> Result<Arc<Template>, Message> {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    let refused = |reason: Message| message!("reports-page-refused").text("file", &name).message("reason", reason);
    let bytes = files::read_file(path).map_err(|error| refused(error.message()))?;
    let text = String::from_utf8_lossy(&bytes);
    let template = Template::read(&text).map_err(|error| refused(error.message()))?;
    let logo = |name: &str| files::read_file(&path.with_file_name(name)).map_err(|error| error.message());
    Ok(Arc::new(template.with_logo(logo)))
}

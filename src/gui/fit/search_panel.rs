//! Left, below: from a wanted clearance to the pairs of classes that give it. Only the rows in sight are drawn.

use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Atom, AtomExt as _, Button, RichText, ScrollArea, Ui, vec2};

use super::parts_panel::pair_ui;
use crate::gui::theme::{self, Hex, control, palette, sizes, space};
use crate::gui::view::{View, heading, one_of_ui, problem, quiet};
use crate::length::Length;
use crate::message::message;
use crate::session::{FitCommand, FitField};
use crate::text::Within as _;
use crate::tolerance::Feature;
use crate::tolerance::fit::search::{Candidate, FitSearchResult, Scope};

/// How many rows the list shows at once.
const ROWS: f32 = 6.0;

const fn scope_id(scope: Scope) -> &'static str {
    match scope {
        Scope::All => "fit-scope-all",
        Scope::Basis => "fit-scope-basis",
        Scope::Preferred => "fit-scope-preferred",
    }
}

/// The wanted clearances, where to search, and what was found.
pub(super) fn search_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("fit-search"));
    pair_ui(
        ui,
        view,
        [(FitField::WantedMinimum, "fit-wanted-minimum", "mm"), (FitField::WantedMaximum, "fit-wanted-maximum", "mm")],
    );
    ui.horizontal(|ui| {
        let name = quiet(ui, view.text("fit-scope"));
        let width = ui.available_width() - space(2.0);
        let now = view.session.fit().scope;
        let scopes = [Scope::All, Scope::Basis, Scope::Preferred].map(|scope| (scope, view.text(scope_id(scope))));
        let (chosen, list) = one_of_ui(ui, "fit-scope", width, &now, scopes);
        list.labelled_by(name.id);
        if let Some(scope) = chosen {
            view.send(FitCommand::SearchAmong(scope));
        }
    });
    let session = view.session;
    match session.fit().found() {
        None if session.fit().nominal.is_none() => _ = quiet(ui, view.text("fit-search-size")),
        None => _ = quiet(ui, view.text("fit-search-hint")),
        Some(Err(error)) => _ = problem(ui, view.words.say(error)),
        Some(Ok(found)) => found_ui(ui, view, found),
    }
}

fn found_ui(ui: &mut Ui, view: &mut View<'_>, found: &FitSearchResult) {
    if let Some(miss) = &found.nearest {
        quiet(ui, view.text("fit-found-none"));
        row_ui(ui, view, &miss.candidate);
        let um = |length: Length| view.words.um(length);
        let missed = message!("fit-missed-by").text("below", um(miss.below)).text("above", um(miss.above));
        quiet(ui, view.words.say(&missed));
        return;
    }
    let shown = found.candidates.len();
    let mut text = view.words.say(&message!("fit-found").count("count", found.total));
    if shown < found.total {
        text = format!("{text}, {}", view.words.say(&message!("fit-found-first").count("count", shown)));
    }
    quiet(ui, text);
    ui.spacing_mut().item_spacing.y = space(0.5);
    let height = (control(ui) + space(0.5)) * ROWS;
    ScrollArea::vertical().id_salt("fit-found").max_height(height).auto_shrink([false, true]).show_rows(
        ui,
        control(ui),
        shown,
        |ui, rows| {
            ui.set_max_width(ui.available_width() - space(2.5));
            for candidate in found.candidates.within(rows) {
                row_ui(ui, view, candidate);
            }
        },
    );
}

/// A pair as a button: its classes, its clearances, and a remark on it.
fn row_ui(ui: &mut Ui, view: &mut View<'_>, candidate: &Candidate) {
    let palette = palette(ui.ctx());
    let Candidate { hole, shaft, minimum, maximum, .. } = *candidate;
    let pair = format!("{hole}/{shaft}");
    let range = format!("{} … {} µm", view.words.signed_um(minimum), view.words.signed_um(maximum));
    let text = |font, colour: Hex| TextFormat::simple(font, colour.0);
    // The clearances are aligned below each other.
    let bold = theme::bold(sizes().body);
    let width = ui.painter().layout_no_wrap(pair.clone(), bold.clone(), palette.text.0).size().x;
    let mut job = LayoutJob::default();
    job.append(&pair, 0.0, text(bold, palette.text));
    job.append(&range, (space(16.0) - width).max(space(2.0)), text(theme::font(sizes().body), palette.text));
    let mut name = format!("{pair}  {range}");
    let remark = remark(view, candidate);
    if let Some(remark) = &remark {
        name = format!("{name}  {remark}");
    }
    // Where room is short, the remark shrinks and the figures stay whole.
    let remark = remark
        .map_or_else(RichText::default, RichText::new)
        .size(sizes().small)
        .color(palette.quiet.0)
        .atom_shrink(true);
    let chosen = (view.session.fit().class(Feature::Hole), view.session.fit().class(Feature::Shaft));
    let button = Button::new((job, Atom::grow(), remark)).truncate().selected(chosen == (Some(hole), Some(shaft)));
    let size = vec2(ui.available_width(), control(ui));
    if ui.add_sized(size, button).accessible_name(name).clicked() {
        view.send(FitCommand::TakePair(hole, shaft));
    }
}

fn remark(view: &View<'_>, candidate: &Candidate) -> Option<String> {
    match (candidate.preference, candidate.function, candidate.basis) {
        (Some(_), _, _) => Some(view.text("fit-is-preferred")),
        (None, Some(function), _) => Some(view.words.told(&function)),
        (None, None, basis) => basis.map(|basis| view.words.told(&basis)),
    }
}

//! Right, below: the groups. Only those in sight are drawn.

use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextWrapping};
use eframe::egui::{ScrollArea, Sense, Ui, WidgetInfo, vec2};

use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, heading, problem};
use crate::message::{Message, message};
use crate::pairing::{Group, Groups, PairClearances, Range};
use crate::text::Within as _;

/// How many groups are listed at once.
const AT_ONCE: f32 = 4.0;

fn line_height() -> f32 {
    sizes().small + space(1.0)
}

/// The groups, and how many parts are in none.
pub(super) fn groups_ui(ui: &mut Ui, view: &View<'_>, groups: &Groups, wanted: PairClearances) {
    heading(ui, view.text("pairing-page-groups-title"));
    let (holes, shafts) = groups.outside();
    if (holes, shafts) != (0, 0) {
        let outside = message!("pairing-page-outside-groups").count("holes", holes).count("shafts", shafts);
        problem(ui, view.words.say(&outside));
    }
    ui.spacing_mut().item_spacing.y = space(1.0);
    let height = line_height() * 4.0 + space(2.0);
    let area = ScrollArea::vertical().id_salt("pairing-groups").max_height((height + space(1.0)) * AT_ONCE);
    area.show_rows(ui, height, groups.all.len(), |ui, places| {
        for (at, group) in places.clone().zip(groups.all.within(places)) {
            let (rect, response) =
                ui.allocate_exact_size(vec2(ui.available_width() - space(2.5), height), Sense::hover());
            let lines = lines(view, at + 1, group, wanted);
            if at % 2 == 1 {
                ui.painter().rect_filled(rect, 3.0, palette(ui.ctx()).sunken.0);
            }
            let colour = palette(ui.ctx()).text.0;
            let mut at = rect.min + vec2(space(1.0), space(1.0));
            for (number, line) in lines.iter().enumerate() {
                let font = if number == 0 { theme::bold(sizes().small) } else { theme::font(sizes().small) };
                let mut job = LayoutJob::simple_singleline(line.clone(), font, colour);
                job.wrap = TextWrapping::truncate_at_width(rect.width() - space(2.0));
                ui.painter().galley(at, ui.painter().layout_job(job), colour);
                at.y += line_height();
            }
            response.widget_info(|| WidgetInfo::labeled(Role::Label, true, lines.join(". ")));
        }
    });
}

/// What is said of a group: pairs and whether any of them is good, both sides, the clearances.
fn lines(view: &View<'_>, number: usize, group: &Group, wanted: PairClearances) -> Vec<String> {
    let words = view.words;
    let within = match group.all_within(wanted) {
        Some(true) => "pairing-page-all-within",
        Some(false) => "pairing-page-not-all-within",
        None => "pairing-page-no-group-pairs",
    };
    let head = message!("pairing-page-group").text("number", number).count("count", group.pairs());
    let side = |id, count: usize, range: Range| {
        words.say(&Message::new(id).count("count", count).number("from", range.from).number("to", range.to))
    };
    let clearances = group
        .clearances
        .map(|clearances| words.say(&message!("pairing-page-group-clearance").text("range", range(view, clearances))));
    [
        format!("{}, {}", words.say(&head), view.text(within)),
        side("pairing-page-group-holes", group.holes, group.hole_range),
        side("pairing-page-group-shafts", group.shafts, group.shaft_range),
    ]
    .into_iter()
    .chain(clearances)
    .collect()
}

/// A range of clearance with its signs: `+7 … +41 µm`.
pub(super) fn range(view: &View<'_>, (smallest, largest): (crate::length::Length, crate::length::Length)) -> String {
    format!("{} … {} µm", view.words.signed_um(smallest), view.words.signed_um(largest))
}

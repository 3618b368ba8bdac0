//! Right, below the verdict: the band, and what was asked for last below it: the reasons, the features, the picture, the last results; at
//! the foot three buttons.

use eframe::egui::{Button, Id, Panel, RichText, ScrollArea, Ui, vec2};

use super::{gap, results};
use crate::gui::card::page_card_ui;
use crate::gui::check::{band_of_ui, check_card, recorded_ui, why_ui};
use crate::gui::columns::of_height;
use crate::gui::limits::limits_text;
use crate::gui::parts::{alarms_ui, features_ui, has_walk_picture, walk_picture_ui};
use crate::gui::shapes::times;
use crate::gui::theme::{self, Icon, Weight, sizes, space};
use crate::gui::view::{View, heading, remembered};
use crate::journal::Record;
use crate::message::message;
use crate::session::{Action, Page, PartsAction, Purpose, Recorded, WindowAction};
use crate::tolerance::Limits;

/// The share of the height that the verdict has, and its limits: the word of an operator's window has 104 dots.
const VERDICT: f32 = 0.28;
const VERDICT_LIMITS: [f32; 2] = [210.0, 300.0];

/// The height of the band.
const BAND: [f32; 2] = [150.0, 220.0];

/// The height of a button at the foot.
const BUTTON: f32 = 56.0;

/// What is shown in the place of the picture.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
enum Shown {
    #[default]
    Usual,
    Why,
    Features,
    Alarms,
}

fn shown_id() -> Id {
    Id::unique("operator-shown")
}

pub(super) fn verdict_height(ui: &Ui) -> f32 {
    (ui.available_height() * VERDICT).clamp(VERDICT_LIMITS[0], VERDICT_LIMITS[1])
}

/// What stands below the verdict.
pub(super) struct Below<'a> {
    pub limits: Option<&'a Limits>,
    pub record: Option<&'a Record>,
    /// What has become of the record.
    pub recorded: Option<Recorded<'a>>,
    pub is_part: bool,
    /// Whether it is a diameter: half of what is removed is on each side.
    pub is_round: bool,
}

pub(super) fn below_ui(ui: &mut Ui, view: &mut View<'_>, below: &Below<'_>) {
    if matches!(below.recorded, Some(Recorded::Failed(_))) {
        recorded_ui(ui, view, below.recorded);
    }
    let all = ui.available_height();
    let has_more = BAND[0] + space(24.0) <= all;
    let shown: Shown = remembered(ui, shown_id());
    let takes_all = !has_more && shown != Shown::Usual;
    if let (Some(limits), false) = (below.limits, takes_all) {
        let height = if has_more { (all * 0.45).clamp(BAND[0], BAND[1]) } else { all };
        of_height(ui, height, |ui| page_card_ui(ui, |ui| band_of_ui(ui, view, limits, below.record)));
        if !has_more {
            return;
        }
        ui.add_space(f32::from(gap(ui)) - ui.spacing().item_spacing.y);
    }
    page_card_ui(ui, |ui| match (shown, below.record) {
        (Shown::Why, Some(record)) => {
            let is_round = below.is_round;
            ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| reasons_ui(ui, view, record, is_round));
        }
        (Shown::Features, _) if below.is_part => features_ui(ui, view),
        (Shown::Alarms, _) if below.is_part && !view.session.parts().alarms.open().is_empty() => {
            ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| alarms_ui(ui, view));
        }
        _ if below.is_part && has_walk_picture(view) => walk_picture_ui(ui, view),
        _ if below.is_part => features_ui(ui, view),
        _ => results::last_ui(ui, view),
    });
}

/// In words of the workshop first, then where the limits come from.
pub(super) fn reasons_ui(ui: &mut Ui, view: &View<'_>, record: &Record, is_round: bool) {
    let card = check_card(view.words, record, is_round);
    heading(ui, format!("{}, {}", card.word, limits_text(view.words, &record.limits)));
    let what = card.instruction.map(|(what, rest)| format!("{what}: {rest}"));
    for line in card.lines.into_iter().chain(what) {
        ui.label(RichText::new(line).font(theme::font(sizes().limits)));
    }
    ui.separator();
    why_ui(ui, view, record);
}

/// A button of the foot.
enum Foot {
    Does(Action, Icon),
    /// Shows something in the place of the picture, or the picture again.
    Shows(Shown, &'static str, Icon),
}

/// Three buttons at the foot of what is left.
pub(super) fn actions_ui(ui: &mut Ui, view: &mut View<'_>, record: Option<&Record>, of_part: &[(Action, Icon)]) {
    let is_part = view.session.page() == Page::Parts;
    if record.is_none() && remembered::<Shown>(ui, shown_id()) == Shown::Why {
        // The reasons were those of another value.
        ui.data_mut(|data| data.insert_temp(shown_id(), Shown::Usual));
    }
    let mut buttons: Vec<Foot> = of_part.iter().map(|(action, icon)| Foot::Does(*action, *icon)).collect();
    if is_part && view.session.parts().walking.is_begun() {
        buttons.push(Foot::Shows(Shown::Features, "operator-features", Icon::ListNumbers));
    } else if is_part || has_plans(view) {
        let page = if is_part { Page::Check } else { Page::Parts };
        buttons.push(Foot::Does(WindowAction::Open(page).into(), if is_part { Icon::Ruler } else { Icon::Cube }));
    }
    if is_part && !view.session.parts().alarms.open().is_empty() {
        buttons.push(Foot::Shows(Shown::Alarms, "walk-page-alarms-short", Icon::WarningCircle));
    }
    buttons.push(Foot::Shows(Shown::Why, "why", Icon::Question));
    let margin = eframe::egui::Margin { top: gap(ui), ..eframe::egui::Margin::ZERO };
    let gap = f32::from(gap(ui));
    let panel = Panel::bottom("operator-actions").resizable(false).show_separator_line(false);
    // Below it there is always room for the band.
    let height = super::target(view).clamp(BUTTON, BUTTON * 1.6);
    panel.exact_size(height + gap).frame(eframe::egui::Frame::new().inner_margin(margin)).show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            let width = (ui.available_width() - times(gap, buttons.len() - 1)) / times(1.0, buttons.len());
            for button in buttons {
                foot_ui(ui, view, &button, (vec2(width, height), record.is_some()));
            }
        });
    });
}

/// Whether there is a plan to measure a part by.
fn has_plans(view: &View<'_>) -> bool {
    view.session.parts().document.plan().is_some() || view.session.recent_of(Purpose::OpenPlan).next().is_some()
}

fn foot_ui(ui: &mut Ui, view: &mut View<'_>, button: &Foot, (size, has_record): (eframe::egui::Vec2, bool)) {
    let shown: Shown = remembered(ui, shown_id());
    let (name, icon, is_on, is_possible) = match button {
        Foot::Does(action, icon) => {
            let name = match action {
                Action::Window(WindowAction::Open(Page::Parts)) => view.text("operator-part"),
                Action::Window(WindowAction::Open(_)) => view.text("operator-one-size"),
                Action::Parts(PartsAction::ReportPart(_)) => view.text("operator-report"),
                action => action.text(view.session, view.words),
            };
            (name, *icon, false, view.session.can(*action))
        }
        Foot::Shows(of, id, icon) => {
            let count = view.session.parts().walking.count();
            let name = view.words.say(&message!("operator-features").count("count", count));
            let name = if *of == Shown::Features { name } else { view.text(id) };
            (name, *icon, shown == *of, *of != Shown::Why || has_record)
        }
    };
    let font = |size: f32| theme::bold(size);
    let room = size.x - space(14.0);
    let wide =
        ui.painter().layout_no_wrap(name.clone(), font(sizes().limits), eframe::egui::Color32::PLACEHOLDER).size().x;
    let text = RichText::new(&name).font(font(sizes().limits * (room / wide.max(1.0)).min(1.0)));
    let look = Button::new((icon.text(Weight::Regular, space(5.5)), text)).selected(is_on).min_size(size);
    let response = theme::looking(ui, theme::tonal, |ui| ui.add_enabled(is_possible, look)).accessible_name(&name);
    if !response.clicked() {
        return;
    }
    match button {
        Foot::Does(action, _) => view.act(*action),
        Foot::Shows(of, ..) => {
            let next = if is_on { Shown::Usual } else { *of };
            ui.data_mut(|data| data.insert_temp(shown_id(), next));
        }
    }
}

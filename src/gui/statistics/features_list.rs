//! Left: the features, each with Ppk as a number and as a bar with a mark at what is usually asked for.

use std::ops::Range;

use eframe::egui::Ui;

use crate::gui::key_names::part_id;
use crate::gui::shapes::screen;
use crate::gui::table::{Cell, Column, Row, Table, found_height};
use crate::gui::view::{View, heading, quiet};
use crate::message::message;
use crate::series::ASKED_INDEX;
use crate::session::StatisticsCommand;
use crate::session::focused::FEATURES;
use crate::text::long;

/// A bar of this Ppk is as long as its column.
const LONGEST: f64 = 2.0;

const COLUMNS: [Column; 3] = [Column::text(24.0).takes_rest(), Column::zone().gives_way(1), Column::figure(12.0)];

pub(super) fn list_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.statistics();
    let asked = view.words.number(&format!("{ASKED_INDEX:.2}"));
    ui.horizontal_wrapped(|ui| {
        heading(ui, view.text("statistics-page-features"));
        quiet(ui, view.words.say(&message!("statistics-page-features-head").text("asked", &asked)));
    });
    let below = page.features().filter(|(_, of)| of.ppk().is_ok_and(|(ppk, _)| ppk < ASKED_INDEX)).count();
    if 0 < below {
        let said = message!("statistics-page-below").text("count", below).text("all", page.features().len());
        quiet(ui, view.words.say(&said.text("asked", asked)));
    }
    let place = page.chosen();
    let table = Table {
        count: page.features().len(),
        height: Some(found_height(ui, 1)),
        look: (place.map_or(0, long), place),
        ..Table::new(part_id(FEATURES), "statistics-page-features", &COLUMNS)
    };
    let seen = table.show(ui, view, rows);
    if let Some(place) = seen.clicked {
        view.send(StatisticsCommand::ChooseFeature(place));
    }
}

fn rows(view: &View<'_>, places: Range<usize>) -> Vec<Row<usize>> {
    let page = view.session.statistics();
    let chosen = page.chosen();
    let with_part = page.series().has_parts();
    let features = page.features().enumerate().skip(places.start).take(places.len());
    let row = |(place, (feature, of)): (usize, (&crate::series::FeatureSeries, &crate::series::Evaluated))| {
        let name = view.words.number(&feature.key.title(with_part));
        let ppk = of.ppk();
        let number = ppk.as_ref().map_or_else(|_| "–".to_owned(), |(ppk, _)| view.words.number(&format!("{ppk:.2}")));
        let bar = ppk.as_ref().ok().map(|(ppk, _)| [*ppk, ASKED_INDEX].map(|index| screen(index / LONGEST)));
        let told = ppk.map_or_else(|why| view.words.told(&why), |_| number.clone());
        let said = message!("statistics-page-feature-said").text("name", &name).count("count", of.counted);
        let said = view.words.say(&said.text("ppk", told));
        let is_chosen = chosen == Some(place);
        let [name, below] = feature.key.lines(with_part).map(|line| view.words.number(&line));
        let cells = vec![Cell::Found { name, line: vec![(below, false)] }, Cell::Bar(bar), Cell::Text(number)];
        let row = Row::new(place, cells, said);
        Row { is_cursor: is_chosen, is_open: is_chosen, ..row }
    };
    features.map(row).collect()
}

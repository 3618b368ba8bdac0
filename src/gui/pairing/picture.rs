//! Middle: holes on the left, shafts on the right, on one scale of size, with the pairs as lines. Of many parts those around
//! the selected pair are drawn, and an overview beside them shows all.

use eframe::egui::text::{LayoutJob, TextWrapping};
use eframe::egui::{Painter, Pos2, Rangef, Rect, Sense, Stroke, StrokeKind, Ui, pos2, vec2};

use crate::exchange::Size;
use crate::gui::shapes::{ratio, screen};
use crate::gui::spoken;
use crate::gui::theme::{self, Palette, palette, sizes, space};
use crate::gui::view::{View, heading, quiet};
use crate::message::message;
use crate::session::{PairRow, Paired, PairingView};
use crate::tolerance::Feature;

/// Half the size of a mark.
const MARK: f32 = 4.5;

/// The least distance between two names.
const LINE: f32 = 16.0;

/// Heading, legend and picture in the room that is left.
pub(super) fn picture_ui(ui: &mut Ui, view: &View<'_>, paired: &Paired) {
    let sight = paired.picture.sight(view.session.pairing().selected);
    ui.horizontal_wrapped(|ui| {
        heading(ui, view.text("pairing-page-picture"));
        let middle = view.words.number(&paired.middle_um());
        quiet(ui, view.words.say(&message!("pairing-page-legend").text("middle", middle)));
        if !sight.is_all {
            quiet(ui, view.text("pairing-page-part-of"));
        }
        if 1 < sight.step() {
            quiet(ui, view.words.say(&message!("pairing-page-thinned").count("step", sight.step())));
        }
    });
    let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::hover());
    if ui.is_rect_visible(rect) {
        let overview = if sight.is_all { 0.0 } else { space(18.0) };
        let painter = ui.painter().with_clip_rect(rect.intersect(ui.clip_rect()));
        let (aside, body) = rect.split_left_right_at_x(rect.left() + overview);
        let drawing = Drawing::new(painter, body, palette(ui.ctx()), view, (paired, &sight));
        if !sight.is_all {
            drawing.overview(aside.shrink2(vec2(space(1.0), 0.0)));
        }
        drawing.draw();
    }
    spoken::picture(ui, &response, view.text("pairing-page-picture"), describe(view, paired, &sight));
}

/// What the picture shows, in words, for users who cannot see it.
fn describe(view: &View<'_>, paired: &Paired, sight: &PairingView) -> String {
    let words = view.words;
    let answer = &paired.answer;
    let holes = &answer.asked.holes.sizes;
    let shafts = &answer.asked.shafts.sizes;
    let mut said = vec![
        words.say(
            &message!("pairing-page-describe")
                .count("holes", holes.len())
                .count("shafts", shafts.len())
                .count("pairs", paired.count())
                .text("middle", words.number(&paired.middle_um())),
        ),
        words.say(
            &message!("pairing-page-left")
                .count("holes", answer.pairing.holes.len())
                .count("shafts", answer.pairing.shafts.len()),
        ) + ".",
    ];
    if !sight.is_all {
        said.push(words.say(&message!("pairing-page-describe-part").count("pairs", sight.pairs.range.len())));
    }
    let selected = view.session.pairing().selected.and_then(|at| paired.row(at));
    if let Some(PairRow { hole, shaft, clearance, .. }) = selected {
        let message = message!("pairing-page-describe-selected")
            .text("hole", paired.hole_name(hole, words))
            .text("shaft", paired.shaft_name(shaft, words))
            .text("clearance", words.signed_um(clearance));
        said.push(words.say(&message));
    }
    said.join(" ")
}

struct Drawing<'a> {
    painter: Painter,
    /// Draws what goes on outside of what is in sight: it covers no heading.
    inner: Painter,
    body: Rect,
    palette: &'a Palette,
    view: &'a View<'a>,
    paired: &'a Paired,
    sight: &'a PairingView,
    /// Where the holes and the shafts stand.
    columns: [f32; 2],
}

/// A mark with the part that it is for.
struct Mark<'a> {
    feature: Feature,
    um: f64,
    part: Option<&'a Size>,
    is_left: bool,
}

impl<'a> Drawing<'a> {
    fn new(
        painter: Painter,
        room: Rect,
        palette: &'a Palette,
        view: &'a View<'a>,
        (paired, sight): (&'a Paired, &'a PairingView),
    ) -> Self {
        // The heads stand above.
        let body = Rect::from_min_max(room.min + vec2(0.0, LINE + 2.0), room.max - vec2(0.0, 2.0));
        let names = (body.width() * 0.36).min(space(52.0));
        let columns = [body.left() + names, body.right() - names];
        let inner = painter.with_clip_rect(body.expand2(vec2(0.0, MARK)).intersect(painter.clip_rect()));
        Self { painter, inner, body, palette, view, paired, sight, columns }
    }

    fn at(&self, feature: Feature, um: f64) -> Pos2 {
        let [holes, shafts] = self.columns;
        let x = if feature == Feature::Hole { holes } else { shafts };
        pos2(x, self.body.bottom() - self.body.height() * screen(self.sight.fraction(um)))
    }

    fn draw(&self) {
        for (feature, id) in [(Feature::Hole, "pairing-page-hole"), (Feature::Shaft, "pairing-page-shaft")] {
            let x = self.at(feature, 0.0).x;
            self.painter.vline(x, self.body.y_range(), Stroke::new(1.0, self.palette.line.0));
            let galley =
                self.painter.layout_no_wrap(self.view.text(id), theme::bold(sizes().small), self.palette.quiet.0);
            let at = pos2(x - galley.size().x / 2.0, self.body.top() - LINE - 2.0);
            self.painter.galley(at, galley, self.palette.quiet.0);
        }
        for at in self.sight.pairs.drawn() {
            self.pair(at, Stroke::new(1.0, self.palette.quiet.0));
        }
        let selected = self.view.session.pairing().selected;
        if let Some(at) = selected {
            self.pair(at, Stroke::new(3.0, self.palette.data.0));
        }
        // The selected pair has its names in any case, leftovers go before other pairs.
        let mut named = [Vec::new(), Vec::new()];
        let first = selected.into_iter().flat_map(|at| self.marks_of(at));
        let left = self.leftovers();
        let rest = self.sight.pairs.drawn().flat_map(|at| self.marks_of(at));
        let marks: Vec<Mark<'_>> = first.chain(left).chain(rest).collect();
        // What is named first covers the others.
        marks.iter().rev().for_each(|mark| self.mark(mark));
        for (number, mark) in marks.iter().enumerate() {
            let of_side = if mark.feature == Feature::Hole { &mut named[0] } else { &mut named[1] };
            self.name(mark, selected.is_some() && number < 2, of_side);
        }
    }

    /// The line of a pair.
    fn pair(&self, at: usize, stroke: Stroke) {
        if let Some([hole, shaft]) = self.paired.picture.pair(at) {
            self.inner.line_segment([self.at(Feature::Hole, hole), self.at(Feature::Shaft, shaft)], stroke);
        }
    }

    fn marks_of(&self, at: usize) -> impl Iterator<Item = Mark<'a>> + use<'a> {
        let places = self.paired.picture.pair(at);
        let row = self.paired.row(at);
        places.into_iter().flat_map(move |[hole, shaft]| {
            let mark = |feature, um, part| Mark { feature, um, part, is_left: false };
            [mark(Feature::Hole, hole, row.map(|row| row.hole)), mark(Feature::Shaft, shaft, row.map(|row| row.shaft))]
        })
    }

    fn leftovers(&self) -> impl Iterator<Item = Mark<'a>> + use<'a> {
        let paired = self.paired;
        let holes = self.sight.holes.drawn().filter_map(|at| {
            Some(Mark {
                feature: Feature::Hole,
                um: paired.picture.hole(at)?,
                part: paired.left_hole(at),
                is_left: true,
            })
        });
        let shafts = self.sight.shafts.drawn().filter_map(|at| {
            let um = paired.picture.shaft(at)?;
            Some(Mark { feature: Feature::Shaft, um, part: paired.left_shaft(at), is_left: true })
        });
        holes.chain(shafts)
    }

    /// A ring for a hole, a disc for a shaft, a cross for what is left over.
    fn mark(&self, mark: &Mark<'_>) {
        let at = self.at(mark.feature, mark.um);
        let colour = self.palette.text.0;
        let stroke = Stroke::new(2.0, colour);
        if mark.is_left {
            for corner in [vec2(MARK, MARK), vec2(MARK, -MARK)] {
                self.inner.line_segment([at - corner, at + corner], stroke);
            }
        } else if mark.feature == Feature::Hole {
            self.inner.circle(at, MARK, self.palette.surface.0, stroke);
        } else {
            self.inner.circle_filled(at, MARK, colour);
        }
    }

    /// The name and the size of a part beside its mark, where no other name is.
    fn name(&self, mark: &Mark<'_>, is_selected: bool, taken: &mut Vec<f32>) {
        let (at, Some(part)) = (self.at(mark.feature, mark.um), mark.part) else { return };
        let is_in_sight = self.body.expand(2.0).y_range().contains(at.y);
        if !is_in_sight || taken.iter().any(|other| (other - at.y).abs() < LINE) {
            return;
        }
        let words = self.view.words;
        let mm = words.number(&self.paired.mm(part));
        let is_hole = mark.feature == Feature::Hole;
        let name = if is_hole { self.paired.hole_name(part, words) } else { self.paired.shaft_name(part, words) };
        let mut text = format!("{name}  {mm}");
        if mark.is_left {
            text = format!("{text}  {}", words.get("pairing-page-left-over"));
        }
        let font = if is_selected { theme::bold(sizes().small) } else { theme::font(sizes().small) };
        let colour = if is_selected || mark.is_left { self.palette.text.0 } else { self.palette.quiet.0 };
        let room = if is_hole { at.x - self.body.left() } else { self.body.right() - at.x } - MARK - space(2.0);
        let mut job = LayoutJob::simple_singleline(text, font, colour);
        job.wrap = TextWrapping::truncate_at_width(room.max(0.0));
        let galley = self.painter.layout_job(job);
        let left = if is_hole { at.x - MARK - space(1.0) - galley.size().x } else { at.x + MARK + space(1.0) };
        let half = galley.size().y / 2.0;
        let y = at.y.clamp(self.body.top() + half - 2.0, (self.body.bottom() - half + 2.0).max(self.body.top() + half));
        taken.push(at.y);
        self.painter.galley(pos2(left, y - half), galley, colour);
    }

    /// All parts as two piles, holes to the left and shafts to the right, leftovers dark on the outside; a frame shows what
    /// is in sight.
    fn overview(&self, room: Rect) {
        let room = Rect::from_min_max(pos2(room.left(), self.body.top()), pos2(room.right(), self.body.bottom()));
        let bins = &self.paired.picture.bins;
        let centre = room.center().x;
        let half = room.width() / 2.0;
        let y = |bin: usize| room.bottom() - room.height() * ratio(bin, bins.len());
        for (number, bin) in bins.iter().enumerate() {
            let height = Rangef::new(y(number + 1), y(number));
            let holes = self.palette.hole.0;
            let shafts = self.palette.shaft.0;
            let sides = [(bin.holes, bin.left_holes, -1.0, holes), (bin.shafts, bin.left_shafts, 1.0, shafts)];
            for (paired, left, side, fill) in sides {
                let inner = half * screen(paired);
                let outer = half * screen(left);
                let bar = |from: f32, to: f32| {
                    let one = centre + side * from;
                    let other = centre + side * to;
                    Rect::from_x_y_ranges(one.min(other)..=one.max(other), height)
                };
                self.painter.rect_filled(bar(0.0, inner), 0.0, fill);
                if 0.0 < outer {
                    let left = bar(inner, (inner + outer).min(half).max(inner + 2.0));
                    self.painter.rect_filled(left, 0.0, self.palette.text.0);
                }
            }
        }
        let share = |um: f64| room.bottom() - room.height() * screen(self.paired.picture.share(um));
        let top = share(self.sight.high);
        let bottom = share(self.sight.low);
        let frame = Rect::from_x_y_ranges(room.x_range(), top..=bottom.max(top + 4.0)).expand2(vec2(2.0, 1.0));
        self.painter.rect_stroke(frame, 2.0, Stroke::new(2.0, self.palette.data.0), StrokeKind::Outside);
    }
}

//! What the fields of the fit page mean. What takes longer than a frame may is kept until its inputs change.

use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::tolerance::fit::Fit;
use fitcheck_core::tolerance::fit::equivalent::{self, Difference};
use fitcheck_core::tolerance::fit::materials::Materials;
use fitcheck_core::tolerance::fit::search::{ClearanceRange, search_in};
use fitcheck_core::tolerance::fit::thermal::{Expansion, ThermalDoubt, ThermalError};
use fitcheck_core::tolerance::{Callout, Feature, Limits, Sources, ToleranceClass};

use super::{Asking, ClassMap, EXAMPLE, Equivalent, FitField, FitPage, Maps};
use crate::check::{class_text, nominal_text};
use crate::state::PageState as _;

/// The most pairs that a search lists; the total is counted in any case.
const MOST_FOUND: usize = 500;

impl FitPage {
    /// Reads the fields anew.
    pub(super) fn read(&mut self, sources: &Arc<Sources>) {
        let side = self.side;
        let scope = self.scope;
        let maps = self.maps.take();
        let asking = self.asking.take();
        let found = self.found.take();
        let texts = std::mem::take(&mut self.texts);
        *self = Self { texts, side, scope, maps, asking, found, ..Self::default() };
        let callout = self.text(FitField::Callout).to_owned();
        self.read_callout(&callout, sources);
        self.read_lengths();
        self.read_temperature();
        self.read_press();
        self.read_maps(sources);
        self.search(sources);
        self.read_example(sources);
    }

    /// An empty page shows a fit as an example: the first character that is typed about a fit takes it away. Limits that do not have
    /// its classes have no example.
    fn read_example(&mut self, sources: &Sources) {
        let about = [
            FitField::Callout,
            FitField::HoleMeasured,
            FitField::ShaftMeasured,
            FitField::WantedMinimum,
            FitField::WantedMaximum,
        ];
        if about.into_iter().all(|field| self.text(field).is_empty()) {
            let mut example = Self::default();
            example.read_callout(EXAMPLE, sources);
            self.example = example.fit.is_some().then(|| Box::new(example));
        }
    }

    fn read_callout(&mut self, text: &str, sources: &Sources) {
        if text.trim().is_empty() {
            return;
        }
        let nominal = nominal_text(text);
        let classes = class_text(text);
        // The map and the search need only the size, even while the classes are being typed.
        self.nominal = nominal.trim_start_matches(['Ø', '⌀']).parse().ok().filter(|nominal| Length::ZERO < *nominal);
        match text.parse::<Callout>() {
            Ok(callout) => {
                self.nominal = Some(callout.nominal());
                self.hole = callout.class_for(Feature::Hole);
                self.shaft = callout.class_for(Feature::Shaft);
                self.read_fit(&callout, sources);
            }
            Err(error) => {
                let mut known = classes.split(['/', '-']).filter_map(|text| text.trim().parse().ok());
                for class in known.by_ref().take(2) {
                    self.put_class(class);
                }
                self.culprit = error.span();
                self.errors.insert(FitField::Callout, error.message());
            }
        }
    }

    pub(super) fn put_class(&mut self, class: ToleranceClass) {
        match class.feature() {
            Feature::Hole => self.hole = Some(class),
            Feature::Shaft => self.shaft = Some(class),
        }
    }

    fn read_fit(&mut self, callout: &Callout, sources: &Sources) {
        let (Some(hole), Some(shaft)) = (self.hole, self.shaft) else {
            self.hint = Some(Message::new(match (self.hole, self.shaft) {
                (Some(_), None) => "fit-shaft-missing",
                (None, Some(_)) => "fit-hole-missing",
                _ => "fit-classes-missing",
            }));
            return;
        };
        match limits(callout, sources) {
            Ok(fit) => {
                self.equivalent = equivalent_of(&fit, hole, shaft, sources);
                self.fit = Some(fit);
            }
            Err(problem) => _ = self.errors.insert(FitField::Callout, problem),
        }
    }

    fn read_lengths(&mut self) {
        let fields = [
            (FitField::HoleMeasured, true),
            (FitField::ShaftMeasured, true),
            (FitField::PressLength, true),
            (FitField::HubOuter, true),
            (FitField::ShaftBore, false),
            (FitField::WantedMinimum, false),
            (FitField::WantedMaximum, false),
        ];
        for (field, above_zero) in fields {
            let text = self.texts.text(field);
            if text.trim().is_empty() {
                continue;
            }
            match text.parse::<Length>() {
                Ok(value) if above_zero && value <= Length::ZERO => {
                    let problem = message!("field-above-zero").number("given", value).number("limit", Length::MAX);
                    self.errors.insert(field, problem);
                }
                Ok(value) => _ = self.lengths.insert(field, value),
                Err(error) => _ = self.errors.insert(field, error.message()),
            }
        }
    }

    fn read_temperature(&mut self) {
        match self.texts.text(FitField::Temperature).parse() {
            Ok(temperature) => self.temperature = Some(temperature),
            Err(error) => self.refuse_thermal(FitField::Temperature, &error),
        }
        for part in [Feature::Hole, Feature::Shaft] {
            let field = FitField::expansion(part);
            match self.texts.text(field).parse() {
                Ok(expansion) => _ = self.expansions.insert(part, expansion),
                Err(error) => self.refuse_thermal(field, &error),
            }
        }
        let Some(temperature) = self.temperature else { return };
        let beyond = |expansion: &Expansion| {
            ThermalDoubt::of_expansion(temperature, *expansion, Materials::shipped().range_of(*expansion))
        };
        if let Some(doubt) = self.expansions.values().find_map(beyond) {
            self.temperature = None;
            self.errors.insert(FitField::Temperature, doubt.message());
        }
    }

    fn refuse_thermal(&mut self, field: FitField, error: &ThermalError) {
        self.errors.insert(field, error.message());
    }

    fn read_maps(&mut self, sources: &Arc<Sources>) {
        let Some(nominal) = self.nominal else { return self.maps = None };
        let is_known = |maps: &Maps| maps.nominal == nominal && Arc::ptr_eq(&maps.sources, sources);
        if self.maps.as_ref().is_some_and(is_known) {
            return;
        }
        let map = |feature| ClassMap::new(feature, nominal, sources);
        let hole = map(Feature::Hole);
        let shaft = map(Feature::Shaft);
        self.maps = Some(Maps { nominal, sources: Arc::clone(sources), hole, shaft });
    }

    fn search(&mut self, sources: &Arc<Sources>) {
        let minimum = self.length(FitField::WantedMinimum);
        let maximum = self.length(FitField::WantedMaximum);
        let asking = self.nominal.zip(minimum.zip(maximum)).map(|(nominal, (minimum, maximum))| Asking {
            nominal,
            wanted: ClearanceRange { minimum, maximum },
            scope: self.scope,
            sources: Arc::clone(sources),
        });
        if asking == self.asking {
            return;
        }
        self.found = asking.as_ref().map(|asking| {
            search_in(asking.nominal, asking.wanted, &asking.sources, asking.scope, MOST_FOUND)
                .map_err(|error| error.message())
        });
        self.asking = asking;
    }
}

/// The fit of a callout that names both classes.
fn limits(callout: &Callout, sources: &Sources) -> Result<Fit, Message> {
    let of = |part| -> Result<Limits, Message> { sources.limits(callout, Some(part)).map_err(|error| error.message()) };
    Fit::new(of(Feature::Hole)?, of(Feature::Shaft)?).map_err(|error| error.message())
}

fn equivalent_of(fit: &Fit, hole: ToleranceClass, shaft: ToleranceClass, sources: &Sources) -> Option<Equivalent> {
    let (hole, shaft) = equivalent::equivalent(hole, shaft)?;
    let callout = Callout::fit(fit.nominal(), hole, shaft).map_err(|error| error.message());
    let other = callout.and_then(|callout| limits(&callout, sources));
    Some(Equivalent { hole, shaft, difference: other.map(|other| Difference::between(fit, &other)) })
}

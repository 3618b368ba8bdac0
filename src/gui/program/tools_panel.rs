//! Left: the tool table, and the tools of Q330; right: what a run has changed in the table.

use eframe::egui::{Button, Id, RichText, Ui, vec2};

use crate::control::variables::Parameter;
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::shapes::ringed;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::tools::{Pick, named_ui, pick_ui, table_list_ui};
use crate::gui::view::{View, heading, quiet};
use crate::message::{Say as _, message};
use crate::session::program::{Run, ToolOf};
use crate::session::{ProgramCommand, ProgramField, WorkpieceAction};

/// The most tools and changes that are drawn.
const MOST: usize = 20;

/// The width of a field that names a tool.
const FIELD: f32 = 24.0;

/// Which table is open, and for each tool of the program which one it is; a list to pick it where it is an input.
pub(super) fn tools_ui(ui: &mut Ui, view: &mut View<'_>) {
    let program = view.session.program();
    let may_measure = program.main().is_some_and(|document| document.may_measure);
    if !may_measure && view.session.tools().is_none() {
        return;
    }
    ui.separator();
    ui.horizontal(|ui| {
        let name = heading(ui, view.text("tools"));
        let width = ui.available_width() - space(2.0);
        table_list_ui(ui, view, "program-tools", width).labelled_by(name.id);
    });
    if view.session.tools().is_none() && !program.tools().is_empty() {
        quiet(ui, view.text("tools-not-monitored"));
    }
    for tool in program.tools().iter().take(MOST) {
        match tool {
            ToolOf::Parameter(parameter) => input_ui(ui, view, *parameter),
            ToolOf::Fixed(tool) => {
                quiet(ui, view.words.say(&message!("tools-fixed").text("tool", tool.text())));
                named_ui(ui, view, Some(tool));
            }
        }
    }
    let more = program.tools().len().saturating_sub(MOST);
    if 0 < more {
        quiet(ui, view.words.say(&message!("tools-more").count("count", more)));
    }
}

/// A tool that is given before a run: typed, or picked from the table.
fn input_ui(ui: &mut Ui, view: &mut View<'_>, parameter: Parameter) {
    let program = view.session.program();
    let field = ProgramField::Tool(parameter);
    let named = program.tool_of(parameter);
    let own = program.own_tool(parameter).map(|own| RichText::new(view.words.number(own)).italics());
    let input = message!("tools-input").text("parameter", parameter);
    let name = quiet(ui, view.words.say(&input));
    ui.horizontal(|ui| {
        let mut look = FieldStyle::number(space(FIELD));
        if let Some(own) = own {
            look.hint = own;
        }
        field_ui(ui, view, field, name.id, look);
        let table = view.session.tools().map(|tools| &tools.table);
        let chosen = table.zip(named.as_ref()).and_then(|(table, named)| named.row(table));
        let pick = Pick { parameter: Some(parameter), chosen, width: ui.available_width() - space(2.0) };
        let salt = Id::unique(("program-tool", parameter));
        let (picked, list) = ui.add_enabled_ui(table.is_some(), |ui| pick_ui(ui, view, salt, &pick)).inner;
        let picker = message!("tools-pick-of").text("parameter", parameter);
        list.accessible_name(view.words.say(&picker));
        if let Some(text) = picked {
            view.send(ProgramCommand::Type(field, text));
        }
    });
    error_ui(ui, view, field);
    named_ui(ui, view, named.as_ref());
}

/// What the run has changed in the table, each with its block, and a button that saves it.
pub(super) fn changes_ui(ui: &mut Ui, view: &mut View<'_>, run: &Run) {
    let changes = run.tool_changes();
    if changes.is_empty() {
        return;
    }
    ui.add_space(space(1.0));
    heading(ui, view.text("tools-changed"));
    if MOST < changes.len() {
        let message = message!("program-page-last-of").count("shown", MOST).count("all", changes.len());
        quiet(ui, view.words.say(&message));
    }
    for changed in changes.iter().skip(changes.len().saturating_sub(MOST)) {
        let text = RichText::new(view.words.say(&changed.change.message())).font(theme::font(sizes().small));
        let button = Button::new(text).frame(false).wrap().min_size(vec2(0.0, control(ui)));
        let button = ui.add(button);
        let button = ringed(ui, button, palette(ui.ctx()).focus.0);
        if button.on_hover_text(view.text("program-page-show-block")).clicked() {
            view.send(ProgramCommand::GoTo(changed.place.clone()));
        }
    }
    view.field_button(ui, WorkpieceAction::SaveTools);
    quiet(ui, view.text("tools-save-hint"));
}

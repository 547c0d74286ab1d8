//! The panel at the right: a field for each column of the selection, or for each setting where that is empty, written into the files as it is typed.

use super::{Editor, EditorPass, layout::BETWEEN, layout::INSIDE, nature::draw_material, nature::show_worlds};
use crate::draw::layout::{Area, DETAILS, TEXT, Vec2, wrapped};
use crate::level::document::{Column, Document, Kind, RowId, SETTINGS, SetCell};
use crate::ui::{Ui, WidgetKind, input::Input, text_field::TextField};
use crate::{draw::Canvas, draw::Style, settings::Key, view::theme, view::widgets, words::tr};

/// The longest cell, characters.
const LONGEST: usize = 400;

#[derive(Clone, Debug)]
pub struct CellField {
    pub column: &'static Column,
    /// `None` where the selected rows differ.
    pub text: Option<String>,
}

/// The field that has the keyboard, by the name of its column.
#[derive(Clone, Debug)]
pub struct Typing {
    name: &'static str,
    field: TextField,
    /// Typing into one field is one operation.
    gesture: u64,
}

pub enum CellWrite {
    Cells(Vec<SetCell>, u64),
    Setting(&'static str, String, u64),
}

#[derive(Clone, Debug, Default)]
pub struct CellPanel {
    pub fields: Vec<CellField>,
    rows: Vec<RowId>,
    /// The kind of all the rows, where they are of one.
    kind: Option<Kind>,
    pub typing: Option<Typing>,
}

impl CellPanel {
    pub fn read(&mut self, document: &Document, rows: &[RowId]) {
        let kinds: Vec<Option<Kind>> = rows.iter().map(|row| document.kind(*row)).collect();
        self.kind = kinds.first().copied().flatten().filter(|first| kinds.iter().all(|kind| *kind == Some(*first)));
        if self.rows != rows {
            self.rows = rows.to_vec();
            self.typing = None;
        }
        self.fields = match self.kind {
            Some(kind) => {
                // The kind of a row of objectives.csv is its own, that of a link is a choice.
                let columns = kind.schema().columns.iter().filter(|column| column.name != "kind" || kind == Kind::Link);
                columns.map(|column| self.field(document, column)).collect()
            }
            None if rows.is_empty() => {
                let text = |column: &Column| Some(document.setting(column.name).unwrap_or_default().to_owned());
                SETTINGS.iter().map(|column| CellField { column, text: text(column) }).collect()
            }
            None => Vec::new(),
        };
    }

    fn field(&self, document: &Document, column: &'static Column) -> CellField {
        let name = column.name;
        let mut texts = self.rows.iter().map(|row| document.cell(*row, name).unwrap_or_default());
        let first = texts.next().unwrap_or_default();
        let text = texts.all(|text| text == first).then(|| first.to_owned());
        CellField { column, text }
    }

    /// Puts the keyboard into the field of a column, where there is one: its text is selected.
    pub fn focus(&mut self, name: &str, gesture: u64) {
        let field = self.fields.iter().find(|field| field.column.name == name);
        self.typing = field.map(|field| Typing {
            name: field.column.name,
            field: TextField::selected(field.text.as_deref().unwrap_or_default(), LONGEST),
            gesture,
        });
    }

    /// Of a click on a field, or beside all; `gesture` is its number. A choice goes on to its next word, or back by the right button.
    fn click(&mut self, under: Option<usize>, input: &Input, gesture: u64) -> Option<CellWrite> {
        let Some(CellField { column, text }) = under.and_then(|index| self.fields.get(index)).cloned() else {
            self.typing = None;
            return None;
        };
        let words = column.choices();
        match self.typing.as_mut().filter(|typing| typing.name == column.name) {
            Some(typing) if words.is_empty() => typing.field.go(usize::MAX, false),
            _ => self.focus(column.name, gesture),
        }
        (!words.is_empty()).then(|| self.write(column, next(&words, text.as_deref(), !input.right_click), gesture))
    }

    /// The operation of the keyboard; `gesture` is the number of the next one.
    fn type_in(&mut self, input: &Input, gesture: u64) -> Option<CellWrite> {
        let typing = self.typing.as_mut()?;
        let at = self.fields.iter().position(|field| field.column.name == typing.name)?;
        if input.pressed(Key::Tab) || input.pressed(Key::Down) || input.pressed(Key::Up) {
            let (count, back) = (self.fields.len(), input.held(Key::Shift) || input.pressed(Key::Up));
            let to = self.fields[(at + if back { count - 1 } else { 1 }) % count].column.name;
            self.focus(to, gesture);
            return None;
        }
        if input.pressed(Key::Enter) || input.pressed(Key::Escape) {
            self.typing = None;
            return None;
        }
        let CellField { column, text } = &self.fields[at];
        let (column, words) = (*column, column.choices());
        let turn = i32::from(input.pressed(Key::Right)) - i32::from(input.pressed(Key::Left));
        if turn != 0 && !words.is_empty() {
            let word = next(&words, text.as_deref(), turn > 0);
            return Some(self.write(column, word, gesture));
        }
        let changed = typing.field.update(input);
        let (text, gesture) = (typing.field.text(), typing.gesture);
        changed.then(|| self.write(column, text, gesture))
    }

    fn write(&mut self, column: &Column, text: String, gesture: u64) -> CellWrite {
        let name = column.name;
        if !column.choices().is_empty()
            && let Some(typing) = &mut self.typing
            && typing.field.text() != text
        {
            typing.field = TextField::new(&text, LONGEST);
        }
        if self.rows.is_empty() {
            return CellWrite::Setting(name, text, gesture);
        }
        CellWrite::Cells(self.rows.iter().map(|row| SetCell { row: *row, column: name, text: text.clone() }).collect(), gesture)
    }
}

/// The word after that one, or the one before it; an empty cell means the first.
fn next(words: &[&str], now: Option<&str>, forward: bool) -> String {
    let at = words.iter().position(|word| now.is_some_and(|now| word.eq_ignore_ascii_case(now))).unwrap_or(0);
    words[(at + if forward { 1 } else { words.len() - 1 }) % words.len()].to_owned()
}

impl Editor {
    pub(super) fn show_panel(&mut self, ui: &mut Ui<'_>, pass: &mut EditorPass) {
        let (canvas, input) = (ui.canvas(), ui.input());
        canvas.rectangle(self.panes.right, theme::panel());
        self.draw_heading(canvas);
        let (mut under, mut world) = (None, None);
        for (index, field) in self.panel.fields.iter().enumerate() {
            let (area, name) = (self.panes.field(index), field.column.name);
            let typing = self.panel.typing.as_ref().filter(|typing| typing.name == name);
            // The one with the keyboard alone has the focus: arrow keys, Tab and Enter are the panel's own.
            ui.touch(name, area, if typing.is_some() { WidgetKind::Field } else { WidgetKind::Tool });
            self.draw_label(canvas, (field.column, typing.is_some()), area, pass);
            match typing.filter(|_| field.column.choices().is_empty()) {
                Some(typing) => typing.field.draw(canvas, area, (DETAILS, INSIDE), Some(ui.time())),
                None => draw_cell(canvas, field, area, pass),
            }
            if name == "material" {
                let text = field.text.as_deref().unwrap_or_default();
                draw_material(canvas, area, if text.is_empty() { field.column.usual } else { text });
            }
            if name == "world" {
                world = show_worlds(ui, pass, (area, field.text.as_deref().unwrap_or_default()), &field.column.choices());
            }
            under = under.or(area.contains(input.pointer).then_some(index));
        }
        self.show_swatches(ui, pass);
        let (taken, below) = self.show_offers(ui, pass);
        self.draw_messages(canvas, below);
        if !pass.open {
            return;
        }
        if let Some(picture) = taken {
            pass.close(None);
            return self.take_picture(&picture);
        }
        let (gesture, clicked) = (self.gesture + 1, input.click || input.right_click);
        let write = if let Some(world) = world {
            Some(CellWrite::Setting("world", world.to_owned(), gesture))
        } else if clicked {
            self.panel.click(under, input, gesture)
        } else {
            self.panel.type_in(input, gesture)
        };
        match write {
            Some(CellWrite::Cells(cells, gesture)) => self.set_as(&self.document.with_law(cells), gesture),
            Some(CellWrite::Setting(name, text, gesture)) => {
                let done = self.document.set_setting(name, &text, Some(gesture));
                self.say_if_refused(done);
            }
            None => {}
        }
        if clicked {
            self.gesture += 1;
        }
    }

    fn draw_heading(&self, canvas: &Canvas) {
        let (heading, place) = match (&self.selection[..], self.panel.kind) {
            ([], _) => (tr("The level").to_owned(), "constants.csv".to_owned()),
            ([row], Some(kind)) => {
                let line = self.document.line(*row).unwrap_or_default();
                (tr(kind.name()).to_owned(), format!("{}:{line}", row.table.file()))
            }
            (rows, Some(kind)) => (format!("{} × {}", rows.len(), tr(kind.name())), kind.table().file().to_owned()),
            (rows, None) => (tr!("{count} things", count = rows.len()), tr("of several kinds").to_owned()),
        };
        let area = self.panes.right.inset(INSIDE);
        canvas.text(&heading, area.min, Style::new(TEXT, theme::text()));
        let at = Vec2::new(area.max().x, area.min.y + 3.0);
        canvas.text(&place, at, Style::new(DETAILS, theme::quiet()).mono().right());
    }

    fn draw_label(&self, canvas: &Canvas, (column, typing): (&'static Column, bool), area: Area, pass: &mut EditorPass) {
        let left = self.panes.right.min.x + INSIDE;
        let style = Style::new(DETAILS, if column.required { theme::text() } else { theme::quiet() });
        canvas.text(column.name, Vec2::new(left, area.centre().y), style.mono().middle());
        if Area::new(left, area.min.y, area.max().x - left, area.size.y).contains(pass.pointer) && !typing {
            pass.tip = Some(column.in_words());
        }
        let edge = match typing {
            _ if self.is_wrong(column.name) => theme::bad(),
            true => theme::accent(),
            false => theme::panel_edge(),
        };
        widgets::panel_in(canvas, area, theme::ground(), edge);
    }

    /// The pictures of the level, where the selection shows one; the one that was pressed, and where they end.
    fn show_offers(&self, ui: &mut Ui<'_>, pass: &mut EditorPass) -> (Option<String>, f32) {
        let (canvas, fields) = (ui.canvas(), self.fields());
        let shows = self.panel.fields.iter().any(|field| field.column.name == "image");
        if !shows || self.offered.is_empty() {
            return (None, self.panes.field(fields).min.y);
        }
        let offers = &self.offered[..self.offered.len().min(self.panes.offers(fields))];
        let style = Style::new(DETAILS, theme::quiet()).mono();
        let more = self.offered.len() - offers.len();
        let words = if more > 0 { tr!("Pictures, and {more} more to write:", more) } else { tr("Pictures to click:").to_owned() };
        canvas.text(&words, self.panes.offer(fields, 0).min - Vec2::new(0.0, self.panes.line), style);
        let mut pressed = None;
        for (index, picture) in offers.iter().enumerate() {
            let area = self.panes.offer(fields, index);
            let touch = ui.touch(picture, area, WidgetKind::Tool);
            if touch.hover {
                canvas.rectangle(area, theme::panel_hover());
            }
            let taken = self.selection.iter().all(|row| self.document.cell(*row, "image") == Some(picture));
            let style = Style { colour: if taken { theme::accent() } else { theme::text() }, ..style };
            let shown = pass.cut(canvas, picture, (area, area.size.x - INSIDE), style);
            canvas.text(&shown, area.min + Vec2::new(INSIDE, 0.0), style);
            pressed = pressed.or(touch.pressed.then(|| picture.clone()));
        }
        (pressed, self.panes.offer(fields, offers.len()).min.y)
    }

    fn take_picture(&mut self, picture: &str) {
        self.gesture += 1;
        self.panel.typing = None;
        let cell = |row: &RowId| SetCell { row: *row, column: "image", text: picture.to_owned() };
        self.set(&self.selection.iter().map(cell).collect::<Vec<_>>());
        self.folder.measure(&mut self.document);
    }

    fn draw_messages(&self, canvas: &Canvas, top: f32) {
        let (area, mut y) = (self.panes.right, top + BETWEEN);
        let columns = ((area.size.x - 2.0 * INSIDE) / self.panes.letter) as usize;
        let own = self.problems.iter().zip(&self.about).filter(|((problem, _), row)| self.is_about(problem, **row));
        for ((problem, refused), _) in own.take(4) {
            let words = tr!(
                "{column}: found {found}, expected {expected}",
                column = problem.column,
                found = problem.found,
                expected = problem.expected
            );
            for line in wrapped(&words, columns.max(8), 0) {
                if y + self.panes.line > area.max().y {
                    return;
                }
                let colour = if *refused { theme::bad() } else { theme::accent() };
                canvas.text(&line, Vec2::new(area.min.x + INSIDE, y), Style::new(DETAILS, colour).mono());
                y += self.panes.line;
            }
        }
    }
}

fn draw_cell(canvas: &Canvas, field: &CellField, area: Area, pass: &mut EditorPass) {
    let (text, colour) = match field.text.as_deref() {
        None => ("…", theme::quiet()),
        Some("") => (field.column.usual, theme::quiet()),
        Some(text) => (text, theme::text()),
    };
    let (style, small) = (Style::new(DETAILS, colour).mono().middle(), Style::new(DETAILS, theme::quiet()).mono().middle());
    let (unit, whole) = (field.column.unit(), area.size.x - 2.0 * INSIDE);
    // The unit gives way to a long text.
    let beside = whole - canvas.width(&unit, small) - INSIDE;
    let fits = canvas.width(text, style) <= beside;
    let shown = pass.cut(canvas, text, (area, if fits { beside } else { whole }), style);
    canvas.text(&shown, Vec2::new(area.min.x + INSIDE, area.centre().y), style);
    if fits {
        canvas.text(&unit, Vec2::new(area.max().x - INSIDE, area.centre().y), small.right());
    }
}

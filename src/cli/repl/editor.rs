//! The session at a terminal: lines with history, completion and colors.

use std::borrow::Cow;
use std::path::Path;

use reedline::{
    Color, ColumnarMenu, Completer, CompletionResult, Emacs, FileBackedHistory, Highlighter, KeyCode, KeyModifiers,
    MenuBuilder, Prompt, PromptEditMode, PromptHistorySearch, Reedline, ReedlineEvent, ReedlineMenu, Signal, Span,
    StyledText, Suggestion, default_emacs_keybindings,
};

use super::super::files;
use super::super::terminal::Terminal;
use super::{Answer, Target, carry_out};
use crate::repl::{COMMANDS, Names, Session, is_of_name};

/// How many lines are kept from one session to the next.
const KEPT: usize = 1000;
/// The name of the menu that completions are chosen from.
const MENU: &str = "completions";

/// Reads lines until the user has enough.
pub(super) fn converse(session: &mut Session<'_>, target: &Target<'_>, terminal: &Terminal) -> Result<u8, u8> {
    terminal.note("`help` lists the commands, Tab completes, Ctrl-D ends the session");
    let mut editor = editor(session.names(), terminal);
    loop {
        let line = match editor.read_line(&Place(session.place())) {
            Ok(Signal::Success(line)) => line,
            Ok(Signal::CtrlD) => return Ok(super::super::CLEAN),
            Ok(_) => continue,
            Err(error) => return Err(terminal.fail(&format!("the terminal cannot be read: {error}"), None)),
        };
        if let Answer::Quit = carry_out(session, &line, target, terminal) {
            return Ok(super::super::CLEAN);
        }
    }
}

fn editor(names: &Names, terminal: &Terminal) -> Reedline {
    let mut keys = default_emacs_keybindings();
    let complete = vec![ReedlineEvent::Menu(MENU.to_owned()), ReedlineEvent::MenuNext];
    keys.add_binding(KeyModifiers::NONE, KeyCode::Tab, ReedlineEvent::UntilFound(complete));
    let menu = ReedlineMenu::EngineCompleter(Box::new(ColumnarMenu::default().with_name(MENU)));
    // Without a place for it, the history is that of the session.
    let history = files::user_state().and_then(|folder| {
        let path = Path::new(&folder).join("lmslc").join("repl_history");
        FileBackedHistory::with_file(KEPT, path).ok()
    });
    let editor = match history {
        Some(history) => Reedline::create().with_history(Box::new(history)),
        None => Reedline::create(),
    };
    editor
        .with_completer(Box::new(Completions(names.clone())))
        .with_highlighter(Box::new(Colors(names.clone())))
        .with_menu(menu)
        .with_quick_completions(true)
        .with_partial_completions(true)
        .with_edit_mode(Box::new(Emacs::new(keys)))
        .with_ansi_colors(terminal.color_out)
}

/// Where the machine is, as a prompt.
struct Place(String);

impl Prompt for Place {
    fn render_prompt_left(&self) -> Cow<'_, str> {
        Cow::Borrowed(&self.0)
    }

    fn render_prompt_right(&self) -> Cow<'_, str> {
        Cow::Borrowed("")
    }

    fn render_prompt_indicator(&self, _: PromptEditMode) -> Cow<'_, str> {
        Cow::Borrowed("> ")
    }

    fn render_prompt_multiline_indicator(&self) -> Cow<'_, str> {
        Cow::Borrowed("  ")
    }

    fn render_prompt_history_search_indicator(&self, search: PromptHistorySearch) -> Cow<'_, str> {
        Cow::Owned(format!(" (search: {}) ", search.term))
    }
}

struct Completions(Names);

impl Completer for Completions {
    fn complete(&mut self, line: &str, position: usize) -> CompletionResult {
        let (start, words) = self.0.complete(line.get(..position).unwrap_or(line));
        let suggest = |word: &str| Suggestion {
            value: word.to_owned(),
            description: COMMANDS.iter().find(|usage| usage.word == word).map(|usage| usage.does.to_owned()),
            span: Span::new(start, position),
            append_whitespace: true,
            ..Suggestion::default()
        };
        CompletionResult::fresh(words.into_iter().map(suggest).collect::<Vec<_>>())
    }
}

/// Commands and names stand out, and so does a command that there is not.
struct Colors(Names);

impl Highlighter for Colors {
    fn highlight(&self, line: &str, _: usize) -> StyledText {
        let mut text = StyledText::new();
        let mut is_first = true;
        for piece in line.split_inclusive(|letter| !is_of_name(letter)) {
            let word = piece.trim_end_matches(|letter| !is_of_name(letter));
            let is_command = COMMANDS.iter().any(|usage| usage.word == word);
            let style = match (is_first && !word.is_empty(), is_command) {
                (true, true) => Color::Default.bold(),
                (true, false) => Color::Red.normal(),
                (false, _) if self.0.knows(word) => Color::Cyan.normal(),
                (false, _) => Color::Default.normal(),
            };
            is_first &= word.is_empty();
            text.push((style, piece.to_owned()));
        }
        text
    }
}

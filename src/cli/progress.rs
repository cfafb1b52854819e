//! How far a long command is, on a terminal only, and gone when it is done.

use std::sync::mpsc::{self, RecvTimeoutError, Sender};
use std::thread::JoinHandle;
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

/// What takes no longer shows nothing.
const DELAY: Duration = Duration::from_millis(500);
/// How often it is drawn while nothing advances.
const BEAT: Duration = Duration::from_millis(100);

/// A line on standard error that ends with this value.
pub(super) struct Progress {
    bar: ProgressBar,
    shown: Option<(Sender<()>, JoinHandle<()>)>,
}

impl Progress {
    /// Of so many items, 0 where nobody knows, that are done one by one. Draws nothing where `is_visible` is false.
    pub(super) fn new(items: usize, what: &'static str, is_visible: bool) -> Self {
        let bar = ProgressBar::with_draw_target(Some(items as u64), ProgressDrawTarget::hidden());
        let form = if items == 0 { "{spinner} {msg}  {elapsed}" } else { "{wide_bar} {pos}/{len} {msg}" };
        // The forms are fixed, and a bar in the crate's own form is better than none.
        bar.set_style(ProgressStyle::with_template(form).unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar.set_message(what);
        let shown = is_visible.then(|| {
            let (over, wait) = mpsc::channel();
            let bar = bar.clone();
            let show = move || {
                if wait.recv_timeout(DELAY) == Err(RecvTimeoutError::Timeout) {
                    bar.set_draw_target(ProgressDrawTarget::stderr());
                    bar.enable_steady_tick(BEAT);
                }
            };
            (over, std::thread::spawn(show))
        });
        Self { bar, shown }
    }

    /// One more item is done.
    pub(super) fn advance(&self) {
        self.bar.inc(1);
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        if let Some((over, thread)) = self.shown.take() {
            drop(over);
            // It does not panic, and what it drew is taken away below.
            let _ = thread.join();
            self.bar.finish_and_clear();
        }
    }
}

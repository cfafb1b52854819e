//! Properties, proved or refuted on a thread of their own, so that nobody waits for a long proof.

use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crossbeam_channel::{Receiver, bounded, never};

use super::known::Known;
use crate::driver::{self, Analysis, Loaded, Options};

/// The thread's work: one document at a time.
#[derive(Default)]
pub(super) struct Proofs {
    at_work: Option<Work>,
}

struct Work {
    path: String,
    /// What is known of the document without its properties.
    quick: Rc<Known>,
    result: Receiver<Analysis>,
    stop: Arc<AtomicBool>,
}

impl Proofs {
    pub(super) fn is_at_work(&self) -> bool {
        self.at_work.is_some()
    }

    /// Begins with a document, which was read for it and of which the rest is known; what was begun before is let go.
    pub(super) fn begin(&mut self, path: &str, quick: Rc<Known>, loaded: Loaded, options: Options) {
        let (done, result) = bounded(1);
        self.at_work = Some(Work { path: path.to_owned(), quick, result, stop: Arc::clone(&options.stop) });
        std::thread::spawn(move || {
            // Nobody takes the result when the server has ended.
            let _ = done.send(driver::examine(loaded, &options));
        });
    }

    /// Where the result comes in.
    pub(super) fn result(&self) -> Receiver<Analysis> {
        self.at_work.as_ref().map_or_else(never, |work| work.result.clone())
    }

    /// Ends the work, and answers the path of its document and what was known of that.
    pub(super) fn end(&mut self) -> Option<(String, Rc<Known>)> {
        self.at_work.take().map(|work| (work.path.clone(), Rc::clone(&work.quick)))
    }

    /// Lets go of work on a document that has changed: it ends with the property that it is at.
    pub(super) fn stop_unless(&self, is_current: impl Fn(&str, &Rc<Known>) -> bool) {
        if let Some(work) = self.at_work.as_ref().filter(|work| !is_current(&work.path, &work.quick)) {
            work.stop.store(true, Ordering::Relaxed);
        }
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        self.stop.store(true, Ordering::Relaxed);
    }
}

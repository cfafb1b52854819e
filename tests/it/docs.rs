//! Every program in the documentation is sound, or says that it shows what is yet to come.

use crate::support::{Fence, analyze_fences, doubts, fences, files_below, report, root};

/// The pages of the documentation, as paths from the root. The pages of diagnostics have tests of their own.
fn pages() -> Vec<String> {
    let mut pages = files_below("docs", &["md"]);
    pages.retain(|path| !path.starts_with("docs/errors/"));
    pages.extend(std::fs::metadata(root().join("README.md")).map(|_| "README.md".to_owned()));
    pages
}

/// A fence with the earlier ones of its page that it may import.
fn with_files(fences: &[Fence], index: usize) -> Vec<&Fence> {
    let files = fences[..index].iter().filter(|fence| fence.is_program() && fence.file.is_some());
    files.chain([&fences[index]]).collect()
}

#[test]
fn every_program_of_the_documentation_is_sound() {
    let (mut programs, mut wrong) = (0, Vec::new());
    for path in pages() {
        let fences = fences(&std::fs::read_to_string(root().join(&path)).unwrap());
        for (index, fence) in fences.iter().enumerate().filter(|(_, fence)| fence.is_program()) {
            programs += 1;
            let analysis = analyze_fences(&with_files(&fences, index));
            let codes: Vec<_> = doubts(&analysis).into_iter().map(|finding| finding.rule.code).collect();
            let is_later = fence.tag.ends_with(",later");
            let sound = codes.is_empty() != is_later && codes.iter().all(|code| *code == "LM0105");
            if !sound {
                wrong.push(format!("{path}:{}\n{}", fence.line, report(&analysis)));
            }
        }
    }
    assert!(programs > 20, "{programs}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_fence_says_what_it_is() {
    let known = [
        "msd",
        "fsfn",
        "msd,later",
        "fsfn,later",
        "text",
        "toml",
        "json",
        "rust",
        "csv",
        "sh",
        "console",
        "yaml",
        "lua",
        "lisp",
    ];
    for path in pages().into_iter().chain(files_below("docs/errors", &["md"])) {
        for fence in fences(&std::fs::read_to_string(root().join(&path)).unwrap()) {
            assert!(known.contains(&fence.tag.as_str()), "{path}:{}: `{}`", fence.line, fence.tag);
        }
    }
}

#[test]
fn every_link_to_a_page_or_heading_leads_somewhere() {
    let slug = |heading: &str| {
        let kept = heading.chars().filter(|c| c.is_alphanumeric() || *c == ' ' || *c == '-');
        kept.collect::<String>().to_lowercase().replace(' ', "-")
    };
    for path in pages() {
        let text = std::fs::read_to_string(root().join(&path)).unwrap();
        let folder = std::path::Path::new(&path).parent().unwrap().to_owned();
        for (_, rest) in text.match_indices("](").map(|(start, _)| text.split_at(start + 2)) {
            let target = rest.split(')').next().unwrap();
            if target.contains("://") {
                continue;
            }
            let (file, heading) = target.split_once('#').unwrap_or((target, ""));
            let file = if file.is_empty() { root().join(&path) } else { root().join(&folder).join(file) };
            assert!(file.exists(), "{path} links to {target}");
            let page = std::fs::read_to_string(&file).unwrap_or_default();
            let mut headings = page.lines().filter_map(|line| line.strip_prefix('#'));
            let found = heading.is_empty() || headings.any(|line| slug(line.trim_start_matches('#').trim()) == heading);
            assert!(found, "{path} links to {target}");
        }
    }
}

//! The names of files: addresses in the protocol, paths in the compiler and in its messages.

use lsp_types::Uri;

/// Where the client works.
#[derive(Debug, Default)]
pub(super) struct Folder {
    /// The folder that paths are relative to, with a slash at its end; empty where the client has none open.
    root: String,
    /// The folder in which the library lies, with a slash at its end.
    library: Option<String>,
}

/// Where the paths of the standard library begin.
pub(super) const LIBRARY: &str = "std/";

impl Folder {
    pub(super) fn new(root: Option<&Uri>, library: Option<String>) -> Self {
        let closed = |path: String| if path.ends_with('/') { path } else { path + "/" };
        Self { root: root.and_then(absolute).map(closed).unwrap_or_default(), library: library.map(closed) }
    }

    /// The root, where there is one.
    pub(super) fn root(&self) -> Option<&str> {
        Some(self.root.as_str()).filter(|root| !root.is_empty())
    }

    /// The path by which the compiler knows a file: from the root where it lies below it, `std/...` where it is one of the
    /// library.
    pub(super) fn path(&self, uri: &Uri) -> String {
        absolute(uri).map_or_else(|| uri.as_str().to_owned(), |path| self.relative(path))
    }

    /// The same for a path on disk.
    pub(super) fn relative(&self, path: String) -> String {
        if let Some(inside) = self.library.as_ref().and_then(|library| path.strip_prefix(library)) {
            return inside.to_owned();
        }
        match path.strip_prefix(&self.root) {
            Some(inside) if inside.starts_with(LIBRARY) => format!("./{inside}"),
            Some(inside) => inside.to_owned(),
            None => path,
        }
    }

    /// The path on disk of a file that the compiler knows.
    pub(super) fn on_disk(&self, path: &str) -> String {
        if path.starts_with('/') || path.contains(':') {
            return path.to_owned();
        }
        match (&self.library, path.starts_with(LIBRARY)) {
            (Some(library), true) => format!("{library}{path}"),
            _ => format!("{}{}", self.root, path.trim_start_matches("./")),
        }
    }

    /// The address of a file that the compiler knows; `None` for one of the library where it can be opened nowhere.
    pub(super) fn uri(&self, path: &str) -> Option<Uri> {
        if path.starts_with(LIBRARY) && self.library.is_none() {
            return None;
        }
        let path = self.on_disk(path);
        let is_drive = path.chars().nth(1) == Some(':');
        if !path.starts_with('/') && !is_drive {
            return path.parse().ok();
        }
        let slash = if is_drive { "/" } else { "" };
        format!("file://{slash}{}", encoded(&path)).parse().ok()
    }
}

/// The path of a file's address; `None` for one of another kind.
fn absolute(uri: &Uri) -> Option<String> {
    let path = decoded(uri.as_str().strip_prefix("file://")?.trim_start_matches(|c| c != '/'))?;
    // `/C:/a.msd` is `C:/a.msd`.
    let is_drive = path.chars().nth(2) == Some(':');
    Some(if is_drive { path.trim_start_matches('/').to_owned() } else { path })
}

fn decoded(text: &str) -> Option<String> {
    let mut bytes = Vec::new();
    let mut rest = text.bytes();
    while let Some(byte) = rest.next() {
        if byte == b'%' {
            let mut digit = || char::from(rest.next()?).to_digit(16);
            bytes.push((digit()? * 16 + digit()?) as u8);
        } else {
            bytes.push(byte);
        }
    }
    String::from_utf8(bytes).ok()
}

fn encoded(path: &str) -> String {
    let plain = |byte: u8| byte.is_ascii_alphanumeric() || b"/-._~:".contains(&byte);
    path.bytes().map(|byte| if plain(byte) { char::from(byte).to_string() } else { format!("%{byte:02X}") }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn uri(text: &str) -> Uri {
        text.parse().unwrap()
    }

    #[test]
    fn addresses_become_paths_and_paths_addresses() {
        let folder = Folder::new(Some(&uri("file:///home/me/my%20robot")), Some("/cache".to_owned()));
        for (address, path) in [
            ("file:///home/me/my%20robot/a.msd", "a.msd"),
            ("file:///home/me/my%20robot/x/%C3%A9.msd", "x/é.msd"),
            ("file:///home/me/my%20robot/std/a.msd", "./std/a.msd"),
            ("file:///home/other/a.msd", "/home/other/a.msd"),
            ("file:///cache/std/robots/j5.msd", "std/robots/j5.msd"),
            ("untitled:Untitled-1", "untitled:Untitled-1"),
        ] {
            assert_eq!(folder.path(&uri(address)), path);
            assert_eq!(folder.uri(path).unwrap().as_str(), address);
        }
        let windows = Folder::new(Some(&uri("file:///c%3A/robots")), None);
        assert_eq!(windows.path(&uri("file:///c%3A/robots/a.msd")), "a.msd");
        assert_eq!(windows.uri("a.msd").unwrap().as_str(), "file:///c:/robots/a.msd");
        assert!(windows.uri("std/robots/j5.msd").is_none());
        assert_eq!(Folder::default().path(&uri("file:///a.msd")), "/a.msd");
    }
}

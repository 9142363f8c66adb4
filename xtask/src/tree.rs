//! The files of the project.

use std::path::{Path, PathBuf};
use std::process::Command;

/// The workspace's folder, wherever the command is called from.
pub(crate) fn root() -> PathBuf {
    let package = std::env::var_os("CARGO_MANIFEST_DIR")
        .map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
    package.parent().map(Path::to_path_buf).unwrap_or(package)
}

/// Every file that is tracked or would be (ignored ones left out), as paths relative to `root` with `/`, sorted.
///
/// Without git, as in an unpacked archive: every file outside `target`, `out` and hidden folders.
pub(crate) fn files(root: &Path) -> Result<Vec<String>, String> {
    let listed = Command::new("git")
        .args(["ls-files", "-z", "--cached", "--others", "--exclude-standard"])
        .current_dir(root)
        .output();
    let mut files: Vec<String> = match listed {
        Ok(output) if output.status.success() => String::from_utf8_lossy(&output.stdout)
            .split('\0')
            .filter(|path| !path.is_empty() && root.join(path).is_file())
            .map(str::to_owned)
            .collect(),
        _ => {
            let mut found = vec![];
            walk(root, "", &mut found).map_err(|problem| format!("{}: {problem}", root.display()))?;
            found
        }
    };
    files.sort();
    files.dedup();
    Ok(files)
}

fn walk(root: &Path, folder: &str, found: &mut Vec<String>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(root.join(folder))? {
        let entry = entry?;
        let name = entry.file_name().to_string_lossy().into_owned();
        let path = if folder.is_empty() { name.clone() } else { format!("{folder}/{name}") };
        if entry.file_type()?.is_dir() {
            let generated = name == "target" || name == "out";
            if !generated && (!name.starts_with('.') || name == ".ci" || name == ".cargo") {
                walk(root, &path, found)?;
            }
        } else {
            found.push(path);
        }
    }
    Ok(())
}

/// The text of a file; `None` where it is not text.
pub(crate) fn text(root: &Path, path: &str) -> Result<Option<String>, String> {
    let bytes = std::fs::read(root.join(path)).map_err(|problem| format!("{path}: {problem}"))?;
    Ok(String::from_utf8(bytes).ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_walk_and_git_agree_on_this_file() {
        let root = root();
        let mut walked = vec![];
        walk(&root, "", &mut walked).expect("the workspace can be read");
        let listed = files(&root).expect("the workspace can be listed");
        for expected in ["xtask/src/tree.rs", "Cargo.toml", ".cargo/config.toml"] {
            assert!(walked.iter().any(|path| path == expected), "the walk misses {expected}");
            assert!(listed.iter().any(|path| path == expected), "the list misses {expected}");
        }
        assert!(listed.iter().all(|path| !path.starts_with("target/")), "built files are listed");
        assert!(walked.iter().all(|path| !path.starts_with("target/")), "built files are walked");
    }
}

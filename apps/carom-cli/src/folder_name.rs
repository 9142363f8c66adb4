//! The name of the folder in which a scene's results lie.

/// Names that Windows keeps for devices, whatever ending follows.
const DEVICES: [&str; 4] = ["CON", "PRN", "AUX", "NUL"];

/// Devices of Windows that a digit follows.
const NUMBERED_DEVICES: [&str; 2] = ["COM", "LPT"];

/// A scene's name as one folder inside another, on every system.
///
/// Signs that part or end a path become `_`, and so do dots and spaces at the end, which Windows drops.
/// A device's name gets `_` in front. Every other name stays as it is.
pub(crate) fn folder_name(scene: &str) -> String {
    let parts_path = |c: char| c.is_control() || matches!(c, '/' | '\\' | ':');
    let mut name: String = scene.chars().map(|c| if parts_path(c) { '_' } else { c }).collect();
    let kept = name.trim_end_matches(['.', ' ']).len();
    let dropped = name.len() - kept;
    name.truncate(kept);
    name.extend(std::iter::repeat_n('_', dropped));
    if is_device(&name) { format!("_{name}") } else { name }
}

fn is_device(name: &str) -> bool {
    let stem = name.split('.').next().unwrap_or(name).trim_end().to_ascii_uppercase();
    let letters = stem.strip_suffix(|c: char| c.is_ascii_digit());
    DEVICES.contains(&stem.as_str()) || letters.is_some_and(|device| NUMBERED_DEVICES.contains(&device))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::{Component, Path};

    #[test]
    fn every_name_is_one_folder_inside() {
        for name in
            ["..", ".", "...", "../x", "a/../../b", "/etc", "..\\x", "C:", "C:\\x", "a\0b", " ", ".. "]
        {
            let made = folder_name(name);
            let parts: Vec<_> = Path::new(&made).components().collect();
            assert!(matches!(parts[..], [Component::Normal(_)]), "{name:?} becomes {made:?}");
            assert!(!made.contains(['\\', ':', '\0']), "{name:?} becomes {made:?}");
            assert!(!made.ends_with(['.', ' ']), "{name:?} becomes {made:?}");
        }
    }

    #[test]
    fn a_device_of_windows_gets_another_name() {
        for name in ["CON", "con", "nul.v2", "COM1", "lpt9", "aux "] {
            assert!(!is_device(&folder_name(name)), "{name:?} becomes {:?}", folder_name(name));
        }
    }

    #[test]
    fn an_ordinary_name_stays() {
        for name in ["case_2", "plate.v2", "Ökonom 3", ".hidden", "console", "COM", "COM10", ""] {
            assert_eq!(folder_name(name), name, "{name:?} is one folder already");
        }
    }
}

//! `carom studio`: serves the studio to the browser of this machine, with a scene to open.

use clap::Args;
use std::path::PathBuf;

#[derive(Args, Debug)]
pub(crate) struct StudioOptions {
    /// Scene file to open; without one, an example.
    #[cfg_attr(
        not(feature = "studio"),
        allow(dead_code, reason = "a build without the studio only says so")
    )]
    pub(crate) scene: Option<PathBuf>,
    /// Port on 127.0.0.1; without one, a free one.
    #[arg(long, value_name = "PORT", default_value_t = 0)]
    #[cfg_attr(
        not(feature = "studio"),
        allow(dead_code, reason = "a build without the studio only says so")
    )]
    pub(crate) port: u16,
    /// Print the address and open no browser.
    #[arg(long)]
    #[cfg_attr(
        not(feature = "studio"),
        allow(dead_code, reason = "a build without the studio only says so")
    )]
    pub(crate) no_open: bool,
}

#[cfg(not(feature = "studio"))]
pub(crate) fn studio(
    _: &StudioOptions,
    _: &crate::args::Output,
    _: &mut impl std::io::Write,
) -> Result<(), crate::failure::Failure> {
    let message = "this carom was built without the studio: `cargo xtask studio` in the sources makes the site, one file that opens \
                   from the disk, and a carom with it";
    Err(crate::failure::Failure::Undone(message.to_owned()))
}

#[cfg(feature = "studio")]
pub(crate) use served::studio;

#[cfg(feature = "studio")]
mod served {
    use super::StudioOptions;
    use crate::args::{Format, Output};
    use crate::failure::Failure;
    use crate::files;
    use crate::printed::tell;
    use carom_scene::Scene;
    use carom_studio::{Server, Site};
    use carom_sweep::disk;
    use std::collections::BTreeMap;
    use std::io::Write;
    use std::path::Path;

    pub(crate) fn studio(
        options: &StudioOptions,
        output: &Output,
        out: &mut impl Write,
    ) -> Result<(), Failure> {
        let site = match &options.scene {
            Some(path) => with_scene(carom_studio::site(), path)?,
            None => carom_studio::site(),
        };
        let server = Server::listen(options.port).map_err(|error| Failure::Undone(error.to_string()))?;
        let address = server.address();
        match output.format {
            Format::Text => writeln!(out, "studio {address}\nctrl-C ends it")?,
            Format::Json => writeln!(out, "{}", serde_json::json!({ "address": address }))?,
        }
        out.flush()?;
        if !options.no_open
            && let Err(failure) = files::open(Path::new(&address))
        {
            tell(&failure.to_string());
        }
        server.run(site);
        Ok(())
    }

    /// The site with a scene and the file that draws its part. A scene with problems opens too: the page shows them.
    fn with_scene(site: Site, path: &Path) -> Result<Site, Failure> {
        let text = disk::read_text(path).map_err(|error| Failure::unread(path, &error))?;
        let mut beside = BTreeMap::new();
        let drawn = Scene::read(path).ok().and_then(|scene| {
            let (name, file) = scene.outline_file()?;
            Some((name.to_owned(), file))
        });
        if let Some((name, file)) = drawn {
            let bytes = disk::read_input(&file).map_err(|error| Failure::unread(&file, &error))?;
            // As the reader of outlines takes them: old drawings have texts in other encodings.
            beside.insert(name, String::from_utf8_lossy(&bytes).into_owned());
        }
        let name = path.file_name().map_or_else(|| "scene.toml".into(), |name| name.to_string_lossy());
        Ok(site.with_scene(&name, &text, &beside))
    }
}

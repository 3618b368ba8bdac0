//! The user's own templates of reports: every TOML file of the folder `templates` beside the state file, with its logo.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::files;
use crate::message::{Message, Say as _, message};
use crate::report::image::Image;
use crate::report::template::Template;

/// The most files that are read.
const MOST: usize = 100;

/// Reads the templates of a folder in the order of their names; none where it does not exist.
pub(super) fn read(folder: &Path) -> Vec<Result<Arc<Template>, Message>> {
    let Ok(list) = files::list(folder) else { return Vec::new() };
    let templates = list.entries.iter().filter(|entry| !entry.is_folder && entry.ends_with(&["toml"]));
    templates.take(MOST).map(|entry| template(&entry.path)).collect()
}

fn template(path: &Path) -> Result<Arc<Template>, Message> {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    let refused = |reason: Message| message!("reports-page-refused").text("file", &name).message("reason", reason);
    let bytes = files::read_file(path).map_err(|error| refused(error.message()))?;
    let text = String::from_utf8_lossy(&bytes);
    let template = Template::read(&text).map_err(|error| refused(error.message()))?;
    let logo = |name: &str| files::read_file(&path.with_file_name(name)).map_err(|error| error.message());
    Ok(Arc::new(template.with_logo(logo)))
}

/// Writes a new template into a folder, which is made where it does not exist, and gives its file. No file there is touched.
///
/// # Errors
/// The folder or the file cannot be written.
pub(super) fn begin(folder: &Path, text: &str) -> Result<PathBuf, Message> {
    let names =
        std::iter::once("template.toml".to_owned()).chain((2..).map(|number| format!("template-{number}.toml")));
    let free = names.take(MOST).map(|name| folder.join(name)).find(|file| !file.exists());
    let file = free.ok_or_else(|| message!("reports-page-too-many-templates").count("count", MOST))?;
    files::make_folder(folder)
        .and_then(|()| files::write_new(&file, text.as_bytes()))
        .map_err(|error| error.message())?;
    Ok(file)
}

/// The logo of a file.
///
/// # Errors
/// The file cannot be read, or is no picture.
pub(super) fn logo(path: &Path) -> Result<Image, Message> {
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    Image::read(&path.file_name().unwrap_or(path.as_os_str()).to_string_lossy(), &bytes)
}

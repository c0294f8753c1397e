use super::FileError;
use std::fs::File;
use std::io::Write;
use std::path::Path;

/// Writes a file so that a reader sees the old content or the new one, never half of one: a temporary file in the same
/// folder, synced, renamed over the target. On an error the target is as it was and the temporary file is gone.
///
/// # Errors
/// When the system refuses.
pub fn write_atomically(path: &Path, content: &[u8]) -> Result<(), FileError> {
    let folder = match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    };
    let mut file = temporary_in(folder)
        .map_err(|e| FileError::system(path, "create a file in this folder", e))?;
    file.write_all(content)
        .map_err(|e| FileError::system(path, "write the file", e))?;
    file.as_file()
        .sync_all()
        .map_err(|e| FileError::system(path, "sync the file", e))?;
    file.persist(path)
        .map_err(|e| FileError::system(path, "rename the finished file", e.error))?;
    // The new name is durable once the folder is; some systems cannot sync folders, and the content is safe either way.
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
    Ok(())
}

/// Finds out whether files can be written to a folder, before the work that makes them.
///
/// # Errors
/// When the system refuses.
pub fn check_writable(folder: &Path) -> Result<(), FileError> {
    temporary_in(folder)
        .map(drop)
        .map_err(|e| FileError::system(folder, "create a file in this folder", e))
}

/// An empty file without a lasting name, gone when dropped.
fn temporary_in(folder: &Path) -> std::io::Result<tempfile::NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".pairtrawl-").suffix(".tmp");
    // Temporary files are private by default; a result is for everyone whom the user's umask allows.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    builder.tempfile_in(folder)
}

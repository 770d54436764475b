//! A folder of pages, served on this machine alone.

use crate::{Refusal, Terminal};
use std::fs::File;
use std::path::{Component, Path, PathBuf};
use tiny_http::{Header, Method, Request, Response, Server};

/// Serves `folder` on the loopback address until the process is stopped. Port 0 is any free one.
pub(super) fn folder(folder: &Path, port: u16, open: bool, terminal: &mut Terminal) -> Result<(), Refusal> {
    let server = Server::http(("127.0.0.1", port))
        .map_err(|e| Refusal::Input(format!("cannot serve on port {port} of this machine: {e}")))?;
    let Some(address) = server.server_addr().to_ip() else {
        return Err(Refusal::Input("the server has no address on this machine".into()));
    };
    let url = format!("http://{address}/");
    writeln!(terminal.out, "open {url}  (Ctrl-C stops)")?;
    terminal.out.flush()?;
    if open {
        // No browser is no error: the address has been told.
        let _ = open::that_detached(&url);
    }
    for request in server.incoming_requests() {
        // A reader that went away is no reason to stop.
        let _ = answer(folder, request);
    }
    Ok(())
}

fn answer(folder: &Path, request: Request) -> std::io::Result<()> {
    let found = (*request.method() == Method::Get).then(|| inside(folder, request.url())).flatten();
    let Some((path, file)) = found.and_then(|path| File::open(&path).ok().map(|file| (path, file))) else {
        return request.respond(Response::from_string("There is no such page.").with_status_code(404));
    };
    let mut response = Response::from_file(file);
    if let Ok(header) = Header::from_bytes("Content-Type", kind(&path)) {
        response.add_header(header);
    }
    request.respond(response)
}

/// The file that a URL names, if it lies inside the folder.
fn inside(folder: &Path, url: &str) -> Option<PathBuf> {
    let path = url.split(['?', '#']).next().unwrap_or_default().trim_start_matches('/');
    let path = Path::new(if path.is_empty() { "index.html" } else { path });
    let plain = path.components().all(|c| matches!(c, Component::Normal(_)));
    Some(folder.join(path)).filter(|path| plain && path.is_file())
}

fn kind(path: &Path) -> &'static str {
    match path.extension().and_then(|e| e.to_str()) {
        Some("html") => "text/html; charset=utf-8",
        Some("toml" | "md" | "obj") => "text/plain; charset=utf-8",
        _ => "application/octet-stream",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_outside_the_folder_is_served() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
        assert_eq!(inside(folder, "/Cargo.toml?x=1"), Some(folder.join("Cargo.toml")));
        for url in ["/../polhode/Cargo.toml", "/src/../../polhode/Cargo.toml", "//etc/passwd", "/nothing", "/src"] {
            assert_eq!(inside(folder, url), None, "{url}");
        }
    }
}

//! One page that holds the viewer and the recordings.

use base64::Engine as _;
use polhode::Error;
use serde::Serialize;

/// What a page says above and below the picture. What is empty is taken from the first recording.
#[derive(Clone, Debug, PartialEq, Eq, Default, Serialize)]
pub struct PageInfo {
    /// What the page is called.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub title: String,
    /// What happens; an empty line starts a paragraph.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub explanation: String,
    /// What to watch.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub look_for: String,
    /// The row of the lecture, or a short text.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub row: String,
    /// Other pages.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub links: Vec<Link>,
}

/// A link of a page.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Link {
    /// Where it leads.
    pub href: String,
    /// What it says.
    pub text: String,
}

/// The comment of the template in whose place the recordings go.
const MARKER: &str = "<!-- recordings -->";

/// The template with the recordings in it, each the bytes of a file: one page that needs nothing else.
///
/// # Errors
/// If the template does not hold `<!-- recordings -->` exactly once.
pub fn page(template: &str, info: &PageInfo, recordings: &[impl AsRef<[u8]>]) -> Result<String, Error> {
    let found = template.matches(MARKER).count();
    let Some((before, after)) = template.split_once(MARKER).filter(|_| found == 1) else {
        return Err(Error::new("template", format!("holds {MARKER:?} {found} times, and not once")));
    };
    let json = serde_json::to_string(info).map_err(|e| Error::new("page", e.to_string()))?;
    // Outside strings JSON has no `<`; inside, this is the same text without a tag that could end the script.
    let json = json.replace('<', "\\u003c");
    let mut page = format!("{before}<script type=\"application/json\" id=\"polhode-page\">{json}</script>");
    for recording in recordings {
        page.push_str("\n<script type=\"application/x-polhode-recording\">");
        base64::engine::general_purpose::STANDARD.encode_string(recording, &mut page);
        page.push_str("</script>");
    }
    page.push_str(after);
    Ok(page)
}

//! The index of the pages.

use core::fmt::Write;

/// One scene of the index.
pub(super) struct Entry {
    /// The folder of the scene: `lecture`, `gallery`, or none.
    pub(super) group: String,
    pub(super) href: String,
    pub(super) scene: String,
    pub(super) title: String,
    pub(super) explanation: String,
    /// Rows of the lecture that it shows.
    pub(super) rows: Vec<u32>,
}

/// A part of the lecture: its rows, and what it is about.
struct Chapter {
    title: &'static str,
    about: &'static str,
    holds: fn(&Entry) -> bool,
}

const CHAPTERS: [Chapter; 6] = [
    Chapter {
        title: "Start here",
        about: "What the engine does, at a glance.",
        holds: |e| e.scene == "scenes/tower.toml",
    },
    Chapter {
        title: "Motion along a path",
        about: "Particles and bodies; position, velocity, acceleration; the frames of a path, and why none of them is the \
                body's own.",
        holds: |e| first_row(e, 3, 19),
    },
    Chapter {
        title: "Rotation, force and torque",
        about: "Angular velocity; forces at a point; what turns a body and what only pushes it.",
        holds: |e| first_row(e, 20, 31),
    },
    Chapter {
        title: "Momentum, mass and inertia",
        about: "What is conserved and when; the centre of mass; the inertia, and the formulas of the slides that are wrong.",
        holds: |e| first_row(e, 32, 40) || first_row(e, 43, 57),
    },
    Chapter {
        title: "Numerical integration",
        about: "One step after another: which schemes gain energy, lose it, or leave the rotations.",
        holds: |e| first_row(e, 41, 42),
    },
    Chapter {
        title: "Gallery",
        about: "Tops, orbits, floats: the same engine, beyond the lecture.",
        holds: |e| e.group == "gallery",
    },
];

fn first_row(entry: &Entry, from: u32, to: u32) -> bool {
    entry.group != "gallery" && entry.rows.first().is_some_and(|row| (from..=to).contains(row))
}

/// `row 40`, `rows 40, 55`, or nothing.
pub(super) fn rows(rows: &[u32]) -> String {
    let list: Vec<String> = rows.iter().map(u32::to_string).collect();
    match list.len() {
        0 => String::new(),
        1 => format!("row {}", list[0]),
        _ => format!("rows {}", list.join(", ")),
    }
}

/// The page.
pub(super) fn html(entries: &[Entry]) -> String {
    let mut body = String::new();
    let mut shown = vec![false; entries.len()];
    for chapter in &CHAPTERS {
        let mut cards = String::new();
        for (entry, shown) in entries.iter().zip(&mut shown) {
            if !*shown && (chapter.holds)(entry) {
                card(entry, &mut cards);
                *shown = true;
            }
        }
        section(chapter.title, chapter.about, &cards, &mut body);
    }
    let mut rest = String::new();
    entries.iter().zip(&shown).filter(|(_, shown)| !**shown).for_each(|(entry, _)| card(entry, &mut rest));
    section("More", "", &rest, &mut body);
    include_str!("index.html").replace("<!-- scenes -->", &body)
}

fn section(title: &str, about: &str, cards: &str, body: &mut String) {
    if !cards.is_empty() {
        // Writing to a string does not fail.
        let _ = write!(body, "<section>\n<h2>{title}</h2>\n<p>{about}</p>\n<ul>\n{cards}</ul>\n</section>\n");
    }
}

fn card(entry: &Entry, into: &mut String) {
    let title = if entry.title.is_empty() { &entry.scene } else { &entry.title };
    let _ = writeln!(
        into,
        "<li><a href=\"{}\"><h3>{}</h3><p>{}</p></a><small>{}<a href=\"{}\">{}</a></small></li>",
        escaped(&entry.href),
        escaped(title),
        escaped(&entry.explanation),
        if entry.rows.is_empty() { String::new() } else { format!("{} · ", rows(&entry.rows)) },
        escaped(&entry.scene),
        escaped(&entry.scene),
    );
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_entry_is_in_the_index_once_and_escaped() {
        let entry = |group: &str, rows: &[u32], title: &str| Entry {
            group: group.into(),
            href: format!("pages/{title}.html"),
            scene: format!("scenes/{title}.toml"),
            title: title.into(),
            explanation: "a < b".into(),
            rows: rows.to_vec(),
        };
        let entries = [
            entry("", &[], "tower"),
            entry("lecture", &[41, 42], "two"),
            entry("gallery", &[], "three"),
            entry("odd", &[], "four"),
        ];
        let page = html(&entries);
        for entry in &entries {
            assert_eq!(page.matches(&format!("href=\"{}\"", entry.href)).count(), 1);
        }
        assert!(page.contains("a &lt; b") && page.contains("rows 41, 42") && !page.contains("<!-- scenes -->"));
    }
}

//! A recording as a table for a spreadsheet or a plotting program.

use super::Recording;
use std::io::{self, Write};

/// Writes a recording as comma-separated values: a line of names, then one line a frame with the time \[s\], every series,
/// and every channel of every body. Positions are in world coordinates, the recording's origin added.
///
/// # Errors
/// If `out` does.
pub fn write_csv(recording: &Recording, out: &mut impl Write) -> io::Result<()> {
    let header = &recording.header;
    let mut names = vec!["time".to_owned()];
    names.extend(header.series.iter().map(|series| series.name.clone()));
    // What is added to each value: the origin where it is a position.
    let mut offsets = Vec::new();
    for body in &header.bodies {
        for channel in &header.channels {
            for k in 0..channel.size {
                names.push(format!("{}.{}.{}", body.name, channel.name, component(channel.size, k)));
                let placed = matches!(channel.name.as_str(), "position" | "center");
                offsets.push(if placed { header.origin.get(k).copied().unwrap_or(0.0) } else { 0.0 });
            }
        }
    }
    let names: Vec<String> = names.iter().map(|name| quoted(name)).collect();
    write!(out, "{}\r\n", names.join(","))?;
    for frame in recording.frames() {
        write!(out, "{}", frame.time)?;
        for value in frame.series {
            write!(out, ",{value}")?;
        }
        for (value, offset) in frame.values.iter().zip(&offsets) {
            // A value that nothing is added to is printed with the digits of f32, not with the many of its f64.
            if *offset == 0.0 { write!(out, ",{value}")? } else { write!(out, ",{}", f64::from(*value) + offset)? }
        }
        write!(out, "\r\n")?;
    }
    out.flush()
}

/// x, y, z of a vector; w, x, y, z of a quaternion; numbers of anything else.
fn component(size: usize, k: usize) -> String {
    match (size, k) {
        (3, _) => ["x", "y", "z"][k].to_owned(),
        (4, _) => ["w", "x", "y", "z"][k].to_owned(),
        _ => k.to_string(),
    }
}

/// As RFC 4180 has it.
fn quoted(name: &str) -> String {
    if name.contains(['"', ',', '\n', '\r']) { format!("\"{}\"", name.replace('"', "\"\"")) } else { name.to_owned() }
}

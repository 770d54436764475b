//! Recordings: what a run leaves behind, and what the page plays. The format is described in `viewer/FORMAT.md`.
//!
//! ```text
//! magic 8 | H u32 | N u32 | header, JSON, H bytes | N frames | CRC-32 of all before
//! frame = time f64 | one f64 a series | for each body its channels, f32 | padding to 8 bytes
//! ```

mod csv;
mod header;
mod page;
mod read;
mod write;

pub use csv::write_csv;
pub use header::{BodyInfo, ChannelInfo, FormInfo, Header, LinkInfo, LinkKind, PlotInfo, SeriesInfo, ShapeInfo};
pub use page::{Link, PageInfo, page};
pub use read::{Frame, Recording};
pub use write::Writer;

/// The first eight bytes of a recording; the last is the version.
pub const MAGIC: [u8; 8] = *b"POLHODE1";

/// Bytes before the header.
const PRELUDE: usize = 16;

/// How the frames of a recording are laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Layout {
    n_series: usize,
    /// f32 values in a frame, all bodies together.
    n_values: usize,
    /// Bytes of a frame, a multiple of 8.
    pub(crate) frame: usize,
}

impl Layout {
    /// `None` if a frame is longer than memory.
    pub(crate) fn of(header: &Header) -> Option<Self> {
        let n_series = header.series.len();
        let row = header.channels.iter().try_fold(0_usize, |sum, channel| sum.checked_add(channel.size))?;
        let n_values = row.checked_mul(header.bodies.len())?;
        let bytes = n_values.checked_mul(4)?.checked_add(n_series.checked_add(1)?.checked_mul(8)?)?;
        Some(Self { n_series, n_values, frame: bytes.checked_next_multiple_of(8)? })
    }
}

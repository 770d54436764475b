//! Writing a recording, frame by frame.

use super::{Header, Layout, MAGIC, PRELUDE};
use crc32fast::Hasher;
use std::io::{self, Seek, SeekFrom, Write};

/// Writes a recording as the run goes on. Nothing is kept in memory: the number of frames, which stands before them, is
/// filled in by [`Writer::finish`].
///
/// ```
/// use polhode_scene::recording::{ChannelInfo, Header, Recording, Writer};
/// # let header: Header = serde_json::from_str(r#"{ "bodies": [], "series": [{ "name": "energy" }],
/// #     "channels": [{ "name": "position", "size": 3 }, { "name": "rotation", "size": 4 }] }"#).unwrap();
///
/// let mut writer = Writer::new(std::io::Cursor::new(Vec::new()), &header)?;
/// writer.frame(0.0, &[1.5], &[])?;
/// let bytes = writer.finish()?.into_inner();
/// assert_eq!(Recording::read(&bytes).unwrap().frame(0).series, [1.5]);
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct Writer<W> {
    out: W,
    layout: Layout,
    frame: Vec<u8>,
    n_frames: u32,
    header_bytes: u32,
    /// Checksum of what follows the number of frames; the rest is joined to it at the end.
    sum: Hasher,
}

impl<W: Write + Seek> Writer<W> {
    /// Writes the header. The recording begins where `out` stands.
    ///
    /// # Errors
    /// If `out` does, or the header is not as [`Header::check`] asks.
    pub fn new(mut out: W, header: &Header) -> io::Result<Self> {
        let invalid = |message: String| io::Error::new(io::ErrorKind::InvalidInput, message);
        header.check().map_err(|e| invalid(e.to_string()))?;
        let layout = Layout::of(header).ok_or_else(|| invalid("a frame is longer than memory".to_owned()))?;
        let mut json = serde_json::to_vec(header)?;
        json.resize((PRELUDE + json.len()).next_multiple_of(8) - PRELUDE, b' ');
        let header_bytes = u32::try_from(json.len()).map_err(|_| invalid("the header is too long".to_owned()))?;
        out.write_all(&MAGIC)?;
        out.write_all(&header_bytes.to_le_bytes())?;
        out.write_all(&[0; 4])?;
        out.write_all(&json)?;
        let mut sum = Hasher::new();
        sum.update(&json);
        Ok(Self { out, layout, frame: Vec::with_capacity(layout.frame), n_frames: 0, header_bytes, sum })
    }

    /// Writes a frame: the time \[s\], one number a series, and for each body in order its channels in order.
    ///
    /// # Errors
    /// If `out` does.
    ///
    /// # Panics
    /// If `series` or `values` are not as many as the header says.
    pub fn frame(&mut self, time: f64, series: &[f64], values: &[f32]) -> io::Result<()> {
        assert_eq!(series.len(), self.layout.n_series, "one number a series");
        assert_eq!(values.len(), self.layout.n_values, "the channels of every body");
        self.frame.clear();
        self.frame.extend(time.to_le_bytes());
        self.frame.extend(series.iter().flat_map(|x| x.to_le_bytes()));
        self.frame.extend(values.iter().flat_map(|x| x.to_le_bytes()));
        self.frame.resize(self.layout.frame, 0);
        self.n_frames = self.n_frames.checked_add(1).ok_or_else(|| io::Error::other("too many frames"))?;
        self.sum.update(&self.frame);
        self.out.write_all(&self.frame)
    }

    /// How many frames have been written.
    pub fn n_frames(&self) -> u32 {
        self.n_frames
    }

    /// Fills in the number of frames, writes the checksum and hands back `out`, which stands at the end.
    ///
    /// # Errors
    /// If `out` does.
    pub fn finish(mut self) -> io::Result<W> {
        let mut sum = Hasher::new();
        sum.update(&MAGIC);
        sum.update(&self.header_bytes.to_le_bytes());
        sum.update(&self.n_frames.to_le_bytes());
        sum.combine(&self.sum);
        self.out.write_all(&sum.finalize().to_le_bytes())?;
        let frames = u64::from(self.n_frames) * self.layout.frame as u64;
        let written = u64::from(self.header_bytes) + frames + 4;
        let back = i64::try_from(written + 4).map_err(io::Error::other)?;
        self.out.seek(SeekFrom::Current(-back))?;
        self.out.write_all(&self.n_frames.to_le_bytes())?;
        self.out.seek(SeekFrom::Current(back - 4))?;
        self.out.flush()?;
        Ok(self.out)
    }
}

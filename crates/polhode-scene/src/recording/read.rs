//! Reading a recording.

use super::{Header, Layout, MAGIC, PRELUDE};
use polhode::Error;

/// A recording in memory.
#[derive(Clone, Debug, PartialEq)]
pub struct Recording {
    /// What its numbers mean.
    pub header: Header,
    layout: Layout,
    times: Vec<f64>,
    series: Vec<f64>,
    values: Vec<f32>,
}

/// One frame of a recording.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame<'a> {
    /// Time \[s\].
    pub time: f64,
    /// One number a series.
    pub series: &'a [f64],
    /// For each body in order its channels in order.
    pub values: &'a [f32],
}

impl Recording {
    /// Reads a recording from its bytes.
    ///
    /// # Errors
    /// If it is no recording, of another version, cut off or too long, if its checksum is wrong, its header is no header
    /// of a recording, or time runs backwards.
    pub fn read(bytes: &[u8]) -> Result<Self, Error> {
        let wrong = |path: &str, message: String| Err(Error::new(path, message));
        if bytes.get(..7) != Some(&MAGIC[..7]) {
            return wrong("", "not a polhode recording".to_owned());
        }
        if bytes.get(7) != Some(&MAGIC[7]) || bytes.len() < PRELUDE + 4 {
            return wrong("", "a recording of another version, or one that is cut off".to_owned());
        }
        let word = |at: usize| bytes[at..at + 4].iter().rev().fold(0_u32, |word, &byte| word << 8 | u32::from(byte));
        let (body, sum) = (&bytes[..bytes.len() - 4], word(bytes.len() - 4));
        let n_frames = word(12) as usize;
        let Some(json) = body.get(PRELUDE..).and_then(|rest| rest.get(..word(8) as usize)) else {
            return wrong("header", format!("of {} bytes, in a file of {}", word(8), bytes.len()));
        };
        let header: Header = serde_json::from_slice(json).map_err(|e| Error::new("header", e.to_string()))?;
        header.check().map_err(|e| e.inside("header"))?;
        let frames = &body[PRELUDE + json.len()..];
        let layout = Layout::of(&header).filter(|layout| layout.frame.checked_mul(n_frames) == Some(frames.len()));
        let Some(layout) = layout else {
            return wrong(
                "frames",
                format!("{n_frames} of them do not take the {} bytes that there are", frames.len()),
            );
        };
        if !(PRELUDE + json.len()).is_multiple_of(8) {
            return wrong("header", "the frames do not start at a multiple of 8 bytes".to_owned());
        }
        if crc32fast::hash(body) != sum {
            return wrong("", "the checksum is wrong: the file was damaged".to_owned());
        }
        let mut recording = Self { header, layout, times: Vec::new(), series: Vec::new(), values: Vec::new() };
        for (i, frame) in frames.chunks_exact(layout.frame).enumerate() {
            recording.add(frame).map_err(|e| e.inside(format!("frames[{i}]")))?;
        }
        Ok(recording)
    }

    fn add(&mut self, frame: &[u8]) -> Result<(), Error> {
        let (numbers, rest) = frame.split_at(8 * (1 + self.layout.n_series));
        let mut numbers = numbers.as_chunks().0.iter().map(|&bytes| f64::from_le_bytes(bytes));
        let time = numbers.next().unwrap_or(f64::NAN);
        let before = self.times.last().copied().unwrap_or(time);
        if !(time.is_finite() && time >= before) {
            return Err(Error::new("time", format!("{time} s comes after {before} s")));
        }
        self.times.push(time);
        self.series.extend(numbers);
        self.values
            .extend(rest[..4 * self.layout.n_values].as_chunks().0.iter().map(|&bytes| f32::from_le_bytes(bytes)));
        Ok(())
    }

    /// How many frames there are.
    pub fn n_frames(&self) -> usize {
        self.times.len()
    }

    /// A frame.
    ///
    /// # Panics
    /// If there are not so many.
    pub fn frame(&self, i: usize) -> Frame<'_> {
        let Layout { n_series, n_values, .. } = self.layout;
        Frame {
            time: self.times[i],
            series: &self.series[i * n_series..][..n_series],
            values: &self.values[i * n_values..][..n_values],
        }
    }

    /// All frames in order.
    pub fn frames(&self) -> impl Iterator<Item = Frame<'_>> {
        (0..self.n_frames()).map(|i| self.frame(i))
    }

    /// The values of a series, one a frame; `None` if there is no such series.
    pub fn series(&self, name: &str) -> Option<Vec<f64>> {
        let column = self.header.series.iter().position(|series| series.name == name)?;
        Some(self.frames().map(|frame| frame.series[column]).collect())
    }
}

impl Frame<'_> {
    /// The values of a channel of a body; `None` if there is no such body or channel.
    pub fn channel(&self, header: &Header, body: usize, name: &str) -> Option<&[f32]> {
        let (start, size) = header.channel(name)?;
        let row = self.values.len().checked_div(header.bodies.len())?;
        self.values.get(body.checked_mul(row)?.checked_add(start)?..)?.get(..size)
    }
}

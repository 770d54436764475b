#![no_main]

use libfuzzer_sys::fuzz_target;
use polhode_scene::Recording;
use polhode_scene::recording::{Writer, write_csv};
use std::io::Cursor;

// The bytes as they are, and with a checksum that fits: otherwise hardly any would get further than that.
fuzz_target!(|bytes: &[u8]| {
    let _ = Recording::read(bytes);
    let mut bytes = bytes.to_vec();
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    let Ok(recording) = Recording::read(&bytes) else { return };
    write_csv(&recording, &mut std::io::sink()).expect("a sink takes all");
    let mut writer = Writer::new(Cursor::new(Vec::new()), &recording.header).expect("the header was read");
    for frame in recording.frames() {
        writer.frame(frame.time, frame.series, frame.values).expect("memory takes all");
    }
    let again = writer.finish().expect("memory takes all").into_inner();
    assert_eq!(Recording::read(&again).expect("it was just written").n_frames(), recording.n_frames());
});

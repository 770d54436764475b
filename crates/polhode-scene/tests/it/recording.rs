//! Recordings: what is written is read, and nothing else is.

use polhode_scene::recording::{
    BodyInfo, ChannelInfo, FormInfo, Header, Link, LinkInfo, LinkKind, PageInfo, PlotInfo, Recording, SeriesInfo,
    ShapeInfo, Writer, page, write_csv,
};
use polhode_scene::scene::Kind;
use proptest::prelude::*;
use std::io::Cursor;

const UPRIGHT: [f64; 4] = [1.0, 0.0, 0.0, 0.0];

fn body(name: &str, forms: &[FormInfo]) -> BodyInfo {
    let shape = |form: &FormInfo| ShapeInfo { form: form.clone(), position: [0.1, 0.2, 0.3], rotation: UPRIGHT };
    BodyInfo {
        name: name.to_owned(),
        kind: Kind::Dynamic,
        color: Some("#4f8fd0".to_owned()),
        mass: Some(1.5),
        inertia: Some([1.0, 2.0, 2.5]),
        principal_rotation: UPRIGHT,
        shapes: forms.iter().map(shape).collect(),
    }
}

fn header() -> Header {
    let forms = [
        FormInfo::Sphere { radius: 1.0 },
        FormInfo::Cuboid { size: [1.0, 2.0, 3.0] },
        FormInfo::Capsule { radius: 0.1, length: 1.0 },
        FormInfo::Ellipsoid { semi_axes: [1.0, 2.0, 3.0] },
        FormInfo::Torus { major: 2.0, minor: 0.5 },
        FormInfo::Mesh { positions: vec![0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0], indices: vec![0, 1, 2] },
        FormInfo::Polygon { points: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]] },
        FormInfo::Ring { inner: 0.1, outer: 0.2 },
    ];
    Header {
        title: "Racket </script> ¼".to_owned(),
        explanation: "Two\nlines".to_owned(),
        look_for: String::new(),
        label: "pdmv6".to_owned(),
        integrator: "pdmv6".to_owned(),
        dt: 0.01,
        frame_interval: 1.0 / 30.0,
        gravity: [0.0, 0.0, -9.81],
        planar: false,
        origin: [1e7, 0.0, -1e7],
        bodies: vec![body("racket", &forms), BodyInfo { mass: None, inertia: None, color: None, ..body("a, b", &[]) }],
        channels: ["position", "rotation", "velocity", "matrix"]
            .map(|name| ChannelInfo::named(name).expect("the format has it"))
            .to_vec(),
        series: vec![
            SeriesInfo { name: "energy".to_owned(), label: "E".to_owned(), unit: "J".to_owned() },
            SeriesInfo { name: "drift".to_owned(), label: "ΔE/E".to_owned(), unit: String::new() },
        ],
        plots: vec![PlotInfo {
            title: "Energy".to_owned(),
            unit: "J".to_owned(),
            series: vec!["energy".to_owned()],
            log: false,
        }],
        links: vec![LinkInfo {
            kind: LinkKind::Spring,
            a: Some(1),
            point_a: [0.0; 3],
            b: None,
            point_b: [0.0, 0.0, 2.0],
        }],
        show: Some(vec!["omega".to_owned()]),
        follow: Some(0),
    }
}

/// Values of two bodies with 3 + 4 + 3 + 9 numbers each.
fn values(seed: f32) -> Vec<f32> {
    (0..38).map(|k| seed + k as f32 * 0.25).collect()
}

fn written(n_frames: usize) -> Vec<u8> {
    let mut writer = Writer::new(Cursor::new(Vec::new()), &header()).expect("memory takes all");
    for i in 0..n_frames {
        let time = i as f64 / 30.0;
        let series = [time * 3.0, if i == 0 { f64::NAN } else { -1e-16 }];
        writer.frame(time, &series, &values(i as f32)).expect("memory takes all");
    }
    assert_eq!(writer.n_frames() as usize, n_frames);
    writer.finish().expect("memory takes all").into_inner()
}

#[test]
fn what_is_written_is_read() {
    for n_frames in [0, 1, 7] {
        let recording = Recording::read(&written(n_frames)).unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(recording.header, header());
        assert_eq!(recording.n_frames(), n_frames);
        for (i, frame) in recording.frames().enumerate() {
            assert_eq!(frame.time, i as f64 / 30.0);
            assert_eq!(frame.series[0], frame.time * 3.0);
            assert_eq!(frame.series[1].is_nan(), i == 0);
            assert_eq!(frame.values, values(i as f32));
            assert_eq!(frame.channel(&recording.header, 1, "velocity"), Some(&values(i as f32)[19 + 7..19 + 10]));
            assert_eq!(frame.channel(&recording.header, 2, "velocity"), None);
            assert_eq!(frame.channel(&recording.header, 0, "force"), None);
        }
        assert_eq!(recording.series("energy").map(|series| series.len()), Some(n_frames));
    }
}

/// The byte layout of the format's table.
#[test]
fn the_bytes_are_those_of_the_format() {
    let bytes = written(2);
    let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
    assert_eq!(&bytes[..8], b"POLHODE1");
    let (header_bytes, n_frames) = (word(8) as usize, word(12));
    assert_eq!(n_frames, 2);
    assert_eq!((16 + header_bytes) % 8, 0);
    // Time and two series, 38 values, and 0 bytes of padding: 24 + 152.
    assert_eq!(bytes.len(), 16 + header_bytes + 2 * 176 + 4);
    assert_eq!(word(bytes.len() - 4), crc32fast::hash(&bytes[..bytes.len() - 4]));
    let json: serde_json::Value = serde_json::from_slice(&bytes[16..16 + header_bytes]).expect("is JSON");
    assert_eq!(json["bodies"][0]["shapes"][1]["type"], "cuboid");
    assert_eq!(json["bodies"][0]["kind"], "dynamic");
    assert_eq!(json["bodies"][0]["shapes"][3]["semi_axes"], serde_json::json!([1.0, 2.0, 3.0]));
    assert_eq!(json["links"][0]["b"], serde_json::Value::Null);
}

/// Seven numbers a body make a frame of 8·1 + 4·7 = 36 bytes, which is padded to 40.
#[test]
fn frames_are_padded_to_eight_bytes() {
    let header = Header {
        bodies: vec![body("b", &[])],
        series: Vec::new(),
        plots: Vec::new(),
        links: Vec::new(),
        channels: header().channels[..2].to_vec(),
        ..header()
    };
    let mut writer = Writer::new(Cursor::new(vec![9; 3]), &header).expect("memory takes all");
    writer.frame(0.5, &[], &[1.0; 7]).expect("memory takes all");
    let bytes = writer.finish().expect("memory takes all").into_inner();
    let header_bytes = u32::from_le_bytes(bytes[8..12].try_into().expect("four bytes")) as usize;
    assert_eq!(bytes.len(), 16 + header_bytes + 40 + 4);
    assert_eq!(Recording::read(&bytes).expect("is read").frame(0).values, [1.0; 7]);
}

#[test]
fn damage_is_found() {
    let bytes = written(3);
    for (at, words) in [(0, "not a polhode recording"), (7, "another version"), (12, "frames"), (200, "header")] {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x40;
        let shown = Recording::read(&damaged).expect_err("it is damaged").to_string();
        assert!(shown.contains(words) || shown.contains("checksum"), "{at}: {shown}");
    }
    let mut damaged = bytes.clone();
    let end = bytes.len();
    damaged[end - 20] ^= 1;
    assert!(Recording::read(&damaged).expect_err("it is damaged").to_string().contains("checksum"));
    for length in [0, 5, 8, 16, 19, 20, 100, end - 1] {
        Recording::read(&bytes[..length]).expect_err("it is cut off");
    }
}

#[test]
fn a_header_that_contradicts_itself_is_refused() {
    type Case = (fn(&mut Header), &'static str);
    let cases: [Case; 8] = [
        (|h| drop(h.channels.remove(1)), "channels: there is no \"rotation\""),
        (|h| h.channels[0].size = 2, "channels[0]: \"position\" cannot have 2 numbers"),
        (|h| h.channels[3].name = "velocity".to_owned(), "channels[3]"),
        (|h| h.series[1].name = "energy".to_owned(), "series[1]: \"energy\" is there twice"),
        (|h| h.plots[0].series.push("heat".to_owned()), "plots[0].series: there is no series \"heat\""),
        (|h| h.links[0].a = Some(2), "links[0]: there is no body 2, of 2"),
        (|h| h.follow = Some(5), "follow: there is no body 5"),
        (
            |h| h.bodies[0].shapes[5].form = FormInfo::Mesh { positions: vec![0.0; 9], indices: vec![0, 1, 3] },
            "bodies[0].shapes[5]: 3 indices do not fit 9 coordinates",
        ),
    ];
    for (change, words) in cases {
        let mut header = header();
        change(&mut header);
        let error = Writer::new(Cursor::new(Vec::new()), &header).expect_err("it is wrong").to_string();
        assert!(error.contains(words), "wanted {words}, found {error}");
    }
}

proptest! {
    /// No bytes make the reader panic, and a recording with any byte changed is refused, wherever the byte is.
    #[test]
    fn no_bytes_make_the_reader_panic(at in 0..1_000_000_usize, flip in 1..=255_u8, noise: Vec<u8>) {
        let mut bytes = written(2);
        let at = at % bytes.len();
        bytes[at] ^= flip;
        prop_assert!(Recording::read(&bytes).is_err());
        prop_assert!(Recording::read(&noise).is_err());
    }
}

#[test]
fn a_table_has_a_column_for_everything() {
    let recording = Recording::read(&written(2)).expect("is read");
    let mut out = Vec::new();
    write_csv(&recording, &mut out).expect("memory takes all");
    let text = String::from_utf8(out).expect("is text");
    let lines: Vec<&str> = text.split("\r\n").collect();
    assert!(
        lines[0]
            .starts_with("time,energy,drift,racket.position.x,racket.position.y,racket.position.z,racket.rotation.w,")
    );
    assert!(lines[0].contains("racket.matrix.8,\"a, b.position.x\","), "{}", lines[0]);
    // The origin is added to the position, and only to it.
    assert!(lines[1].starts_with("0,0,NaN,10000000,0.25,-9999999.5,0.75,"), "{}", lines[1]);
    assert_eq!(lines[2].split(',').count(), 1 + 2 + 38);
    assert_eq!((lines.len(), lines[3]), (4, ""));
}

#[test]
fn a_page_holds_the_recordings_and_no_loose_tag() {
    let info = PageInfo {
        title: "</script><script>alert(1)</script>".to_owned(),
        row: "42".to_owned(),
        links: vec![Link { href: "index.html".to_owned(), text: "All".to_owned() }],
        ..PageInfo::default()
    };
    let made = page("<body><!-- recordings --><script>x</script></body>", &info, &[b"one".as_slice(), b"two"])
        .expect("is made");
    assert_eq!(
        made,
        "<body><script type=\"application/json\" id=\"polhode-page\">{\"title\":\"\\u003c/script>\\u003cscript>alert(1)\\u003c/script>\",\
         \"row\":\"42\",\"links\":[{\"href\":\"index.html\",\"text\":\"All\"}]}</script>\n\
         <script type=\"application/x-polhode-recording\">b25l</script>\n\
         <script type=\"application/x-polhode-recording\">dHdv</script><script>x</script></body>"
    );
    let none: [&[u8]; 0] = [];
    assert!(page("<body></body>", &info, &none).expect_err("no marker").to_string().contains("0 times"));
}

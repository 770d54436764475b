//! The bench runs and reports; what it reports is nothing for a test.

use crate::polhode;
use serde_json::Value;

#[test]
fn a_small_bench_reports_its_figures() {
    let (code, out, err) = polhode(&[
        "bench",
        "free",
        "--bodies",
        "100",
        "--steps",
        "2",
        "--threads",
        "2",
        "--integrator",
        "pdmv4",
        "--json",
    ]);
    assert_eq!((code, err.as_str()), (0, ""));
    let report: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(report["bodies"], 100);
    let figures = report["figures"].as_array().expect("figures");
    assert_eq!(figures.len(), 4, "with and without gravity, with many lanes and with one");
    for figure in figures {
        let (median, best) = (figure["median_ns"].as_f64().expect("median"), figure["best_ns"].as_f64().expect("best"));
        assert!(0.0 < best && best <= median, "{figure}");
    }
}

#[test]
fn the_table_names_every_integrator_it_measures() {
    let (code, out, _) = polhode(&["bench", "free", "--bodies", "50", "--steps", "1"]);
    assert_eq!(code, 0);
    for name in ["pdmv4", "pdmv6", "pdmv8", "pdmv10", "dmv", "exact", "50 free cuboids", "1 thread,"] {
        assert!(out.contains(name), "{name} is not in\n{out}");
    }
}

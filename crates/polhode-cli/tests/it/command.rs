//! Arguments, exit codes, and what is printed where.

use crate::polhode;
use serde_json::Value;
use std::process::Command;

/// A check that takes no time.
const QUICK: &str = "impulse";

#[test]
fn a_passing_check_exits_with_0_and_tells_all_of_it() {
    let (code, out, err) = polhode(&["check", QUICK]);
    assert_eq!((code, err.as_str()), (0, ""));
    for said in ["An impulse J at r", "v − J/m", "a product, a sum", "1 checks", "all passed"] {
        assert!(out.contains(said), "`{said}` is not in\n{out}");
    }
}

#[test]
fn a_failing_check_exits_with_1() {
    let (code, out, _) = polhode(&["check", "parabola", "impulse", "--with-integrator", "explicit-euler"]);
    assert_eq!(code, 1);
    assert!(out.contains("1 failed:") && out.contains("FAILED"), "{out}");
    let (code, out, _) = polhode(&["check", "parabola", "--json", "--with-integrator", "explicit-euler"]);
    let report: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!((code, &report["passed"]), (1, &Value::Bool(false)));
}

#[test]
fn a_check_that_cannot_be_measured_has_failed() {
    let (code, out, _) = polhode(&["check", "hinge", "--with-integrator", "rk4"]);
    assert_eq!(code, 1);
    assert!(out.contains("rk4 does not close pinned points"), "{out}");
}

#[test]
fn a_report_for_a_machine_holds_every_figure() {
    let (code, out, _) = polhode(&["check", QUICK, "mass-50-matrix", "--json"]);
    assert_eq!(code, 0);
    let report: Value = serde_json::from_str(&out).expect("JSON");
    assert_eq!(report["passed"], Value::Bool(true));
    let checks = report["checks"].as_array().expect("checks");
    assert_eq!(checks.len(), 2);
    for check in checks {
        for key in ["group", "name", "law"] {
            assert!(check[key].is_string(), "{key}");
        }
        assert!(check["seconds"].is_f64());
        for measured in check["measured"].as_array().expect("figures") {
            assert!(measured["error"].as_f64().expect("error") <= measured["tolerance"].as_f64().expect("tolerance"));
            assert!(measured["what"].is_string() && measured["because"].is_string());
        }
    }
}

#[test]
fn groups_are_names_too_and_the_order_is_the_suites() {
    let (code, out, _) = polhode(&["check", "mass", QUICK, "--list", "--json"]);
    assert_eq!(code, 0);
    let list: Value = serde_json::from_str(&out).expect("JSON");
    let names: Vec<&str> = list.as_array().expect("a list").iter().filter_map(|c| c["name"].as_str()).collect();
    assert_eq!(names[0], QUICK);
    assert!(names.len() > 5 && names[1..].iter().all(|name| name.starts_with("mass-")), "{names:?}");
}

#[test]
fn the_list_runs_nothing_and_names_everything() {
    let (code, out, _) = polhode(&["check", "--list"]);
    assert_eq!(code, 0);
    for check in polhode_cli::check::suite() {
        assert!(out.contains(check.name) && out.contains(check.law), "{}", check.name);
    }
}

#[test]
fn the_published_tables_are_printed() {
    let (code, out, _) = polhode(&["check", "gazebo"]);
    assert_eq!(code, 0);
    for heading in ["position [m]", "angle [rad]", "wall/sim", "complex"] {
        assert!(out.contains(heading), "{heading}");
    }
}

#[test]
fn what_cannot_be_used_exits_with_2_and_helps() {
    let (code, out, err) = polhode(&["check", "orderz"]);
    assert_eq!((code, out.as_str()), (2, ""));
    assert!(err.contains("did you mean `orders`?") && err.contains("--list"), "{err}");
    for wrong in [&["check", "--jsn"][..], &["chek"], &[], &["bench"], &["bench", "free", "--bodies", "0"]] {
        let (code, out, err) = polhode(wrong);
        assert_eq!((code, out.as_str()), (2, ""), "{wrong:?}");
        assert!(!err.is_empty(), "{wrong:?}");
    }
    let (code, _, err) = polhode(&["check", "--with-integrator", "pdmv7"]);
    assert_eq!(code, 2);
    assert!(err.contains("pdmv10"), "{err}");
}

#[test]
fn help_is_an_answer_and_no_error() {
    for ask in [&["--help"][..], &["check", "--help"], &["--version"]] {
        let (code, out, err) = polhode(ask);
        assert_eq!((code, err.as_str()), (0, ""), "{ask:?}");
        assert!(out.contains("polhode"), "{out}");
    }
    let (_, out, _) = polhode(&["check", "--help"]);
    assert!(!out.contains("with-integrator"), "what makes checks fail is for the tests");
}

/// The program itself: its exit code, and no colours and no bar where nobody looks.
#[test]
fn the_program_writes_plain_text_into_a_pipe() {
    let run = |arguments: &[&str]| {
        Command::new(env!("CARGO_BIN_EXE_polhode")).args(arguments).output().expect("the program starts")
    };
    let passed = run(&["check", QUICK]);
    assert_eq!(passed.status.code(), Some(0));
    assert!(!passed.stdout.contains(&0x1b) && passed.stderr.is_empty(), "{passed:?}");
    let failed = run(&["check", "parabola", "--with-integrator", "explicit-euler"]);
    assert_eq!(failed.status.code(), Some(1));
    assert!(!failed.stdout.contains(&0x1b));
    let refused = run(&["check", "nothing"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(refused.stdout.is_empty() && refused.stderr.starts_with(b"error: no check"), "{refused:?}");
}

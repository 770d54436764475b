//! The exact free rotation against everything it can be checked with.

use super::reference::{free_tops, numbers, quat, vec3};
use polhode::integrate::exact::rotate;
use polhode::math::Quat;
use serde_json::Value;

#[test]
fn exact_rotation_meets_every_row_of_the_references() {
    for top in free_tops() {
        let mut worst: f64 = 0.0;
        for (t, attitude, w) in &top.rows {
            let rot = rotate(Quat::IDENTITY, top.l, top.inertia, *t);
            let e = rot.angle_to(*attitude);
            let wb = rot.inverse_rotate(top.l);
            let ew = (polhode::math::Vec3::new(wb.x / top.inertia.x, wb.y / top.inertia.y, wb.z / top.inertia.z) - *w)
                .length();
            worst = worst.max(e).max(ew);
        }
        println!("{} {worst:e} h|w| {}", top.name, top.fastest() * top.rows.last().unwrap().0);
    }
}

#[test]
fn exact_rotation_is_as_good_as_its_input_next_to_every_limit() {
    let json: Value =
        serde_json::from_str(include_str!("../../../../polhode-cli/reference/free_body_hard.json")).unwrap();
    let mut worst: f64 = 0.0;
    for row in json["rows"].as_array().unwrap() {
        let [inertia, l, q] = [1, 2, 4].map(|k| numbers(&row[k]));
        let (h, condition) = (row[3].as_f64().unwrap(), row[5].as_f64().unwrap());
        let error = rotate(Quat::IDENTITY, vec3(&l), vec3(&inertia), h).angle_to(quat(&q));
        println!(
            "{:20} {:e} cond {condition:e} ratio {:.2}",
            row[0],
            error,
            error / (f64::EPSILON * (1.0 + condition))
        );
        worst = worst.max(error / (f64::EPSILON * (1.0 + condition)));
    }
    println!("{worst}");
}

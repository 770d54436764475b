use polhode::integrate::{lanes::{self, Lanes}, pdmv::Order};
use polhode::math::*;
fn main() {
    let n = 50_000;
    let mut rot = vec![Quat::IDENTITY; n];
    let mut l = vec![]; let mut k = vec![];
    for i in 0..n { let s = i as f64 * 0.37; l.push(Vec3::new(libm::sin(s)*5., libm::cos(s)*4., libm::sin(2.*s))); k.push(Vec3::new(1.0,0.5,1.0/3.0)); }
    for w in [Lanes::One, Lanes::Native] { for o in [Order::Two, Order::Four, Order::Six, Order::Eight, Order::Ten] {
        let mut best = f64::MAX;
        for _ in 0..20 { let t = std::time::Instant::now();
            lanes::rotate(w, o, &mut rot, &l, &k, 1.0/60.0, &mut |_| {});
            best = best.min(t.elapsed().as_secs_f64()); }
        println!("{w:?} {} {o:?} {:.1} ns/body", w.count(), best*1e9/n as f64);
    } }
    println!("{:?}", rot[7]);
}

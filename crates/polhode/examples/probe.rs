use polhode::prelude::*;
use polhode::integrate::*;
fn bruls(scheme: &str, h: f64) {
    let mut w = World::new();
    w.set_integrator(scheme.parse().unwrap()).unwrap();
    let b = w.add(Body::dynamic().mass_properties(MassProperties::new(15.0, [0.,1.,0.], [[0.234375,0.,0.],[0.,0.46875,0.],[0.,0.,0.234375]]).unwrap())
      .velocity(Vec3::new(0.0,150.0,-4.61538).cross(Vec3::Y)).angular_velocity([0.0,150.0,-4.61538])).unwrap();
    let pin = w.pin(b, [0.,0.,0.]).unwrap();
    let e0 = w.energy().total();
    let n = (2.0/h).round() as usize; let mut de: f64 = 0.; let mut gap: f64 = 0.; let mut it=0;
    let t0 = std::time::Instant::now();
    for _ in 0..n { let r = w.step(h); de = de.max((w.energy().total()-e0).abs()); gap = gap.max(r.pins.gap); it = it.max(r.pins.iterations); }
    let el = t0.elapsed().as_secs_f64();
    let e = (w.body(b).center_of_mass() - Vec3::new(-0.15041682274564175,-0.7241655916368956,-0.6730222695604441)).length();
    println!("{scheme:22} h={h} err {e:.2e} dE/mgl {:.1e} gap {gap:.1e} it {it} {:.0} ns/step  reaction {:?}", de/(15.*9.81), el*1e9/n as f64, w.pin_reaction(pin));
}
fn main() {
    for s in ["pdmv6","pdmv10","exact","splitting","suzuki4:pdmv10","kahan-li6:pdmv10","kahan-li8:pdmv10"] { for h in [0.004,0.002,0.001,0.0005] { bruls(s,h); } }
    let _ = Integrator::default();
    // bench
    for n in [1000usize, 50_000] {
    let mut w = World::new();
    for i in 0..n { let s = i as f64*0.37; w.add(Body::dynamic().shape(Shape::cuboid([0.1,0.4,0.9])).position([i as f64,0.,0.]).velocity([0.,1.,2.]).angular_velocity([libm::sin(s)*5., libm::cos(s)*4., libm::sin(2.*s)])).unwrap(); }
    for th in [1,2] { w.set_threads(th).unwrap();
    let mut best = f64::MAX; for _ in 0..60 { let t=std::time::Instant::now(); for _ in 0..(50_000/n) {w.step(1./60.);} best = best.min(t.elapsed().as_secs_f64()); }
    println!("n {n} threads {th}: {:.1} ns per body-step", best*1e9/50_000.); }
    }
}

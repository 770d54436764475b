//! `polhode run`: a scene from a file to a summary, and to a page, a table or a recording.

use crate::terminal::{FAINT, HEADING, styled};
use crate::{Outcome, Progress, Refusal, Terminal};
use polhode_scene::recording::{PageInfo, Recording, page, write_csv};
use polhode_scene::run::Summary;
use polhode_scene::scene::{Compare, Settings, TimeStep};
use polhode_scene::{Run, SceneFile};
use std::fs::File;
use std::io::{self, BufWriter, Cursor, Write};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The page that plays a recording; built from `viewer/`.
pub(crate) const VIEWER: &str = include_str!("../../../viewer/dist/viewer.html");

/// A page larger than this is more than a browser likes to open \[bytes\].
const LARGEST_PAGE: u64 = 512 << 20;

/// Simulate a scene
#[derive(Debug, clap::Args)]
pub struct Arguments {
    /// The scene, a TOML file
    scene: PathBuf,
    /// How long to simulate [s], instead of the scene's time
    #[arg(long, value_name = "S", value_parser = seconds, allow_negative_numbers = true)]
    time: Option<f64>,
    /// The time step [s], a number or a quotient such as 1/240, instead of the scene's
    #[arg(long, value_name = "H", value_parser = seconds, allow_negative_numbers = true)]
    dt: Option<f64>,
    /// The integrator, instead of the scene's; several go side by side.
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    integrator: Vec<String>,
    /// Threads of a step; they change no result
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..))]
    threads: u16,
    /// Write a self-contained page that plays the run in any browser
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Write times, series and positions as a table
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write a recording (viewer/FORMAT.md)
    #[arg(long, value_name = "FILE")]
    record: Option<PathBuf>,
}

/// Reads a positive number of seconds, or a quotient.
fn seconds(text: &str) -> Result<f64, String> {
    let number = |part: &str| part.trim().parse::<f64>().map_err(|_| format!("`{part}` is no number"));
    let value = match text.split_once('/') {
        Some((a, b)) => number(a)? / number(b)?,
        None => number(text)?,
    };
    if value > 0.0 && value.is_finite() { Ok(value) } else { Err(format!("{value} s is not a positive time")) }
}

/// One variant of the scene after its run.
struct Finished {
    label: String,
    integrator: String,
    summary: Summary,
    wall: f64,
    recording: Vec<u8>,
}

impl Arguments {
    /// Runs every variant of the scene and writes what was asked for.
    pub(crate) fn execute(&self, terminal: &mut Terminal) -> Result<Outcome, Refusal> {
        let mut file = SceneFile::load(&self.scene).map_err(scene_error)?;
        self.overrule(&mut file)?;
        let mut runs = prepare(&file)?;
        for run in &mut runs {
            run.world_mut().set_threads(usize::from(self.threads))?;
        }
        if self.html.is_some() {
            require_a_page_that_opens(&runs)?;
        }
        let labels: Vec<String> = runs.iter().map(|run| run.header().label.clone()).collect();
        let outputs = Outputs::prepare(self, &labels)?;
        let keep = self.html.is_some() || self.csv.is_some() || self.record.is_some();
        let finished = simulate(runs, keep)?;
        // First the files: a reader that stops listening must not cost them.
        let written = outputs.write(&finished)?;
        summarize(&file, &finished, terminal.out)?;
        for (what, path) in written {
            writeln!(terminal.out, "{what:<10}{}", path.display())?;
        }
        Ok(Outcome::Done)
    }

    /// What the command line says goes before what the scene says.
    fn overrule(&self, file: &mut SceneFile) -> Result<(), Refusal> {
        for name in &self.integrator {
            name.parse::<polhode::integrate::Integrator>()?;
        }
        let scene = &mut file.scene;
        let all = std::iter::once(&mut scene.settings).chain(scene.compare.iter_mut().map(|c| &mut c.settings));
        for settings in all {
            if self.time.is_some() {
                settings.time = self.time;
            }
            if let Some(dt) = self.dt {
                settings.dt = Some(TimeStep(dt));
            }
            if let [name] = self.integrator.as_slice() {
                settings.integrator = Some(name.clone());
            }
        }
        if self.integrator.len() > 1 {
            let side = |name: &String| Compare {
                settings: Settings { integrator: Some(name.clone()), ..scene.settings.clone() },
                label: name.clone(),
                body: None,
                force: None,
                field: None,
                pin: None,
            };
            scene.compare = self.integrator.iter().map(side).collect();
        }
        Ok(())
    }
}

fn require_a_page_that_opens(runs: &[Run]) -> Result<(), Refusal> {
    let size: u64 = runs.iter().map(Run::recording_bytes).fold(0, u64::saturating_add);
    // Base64 writes four bytes for three.
    if size / 3 * 4 <= LARGEST_PAGE {
        return Ok(());
    }
    Err(Refusal::Input(format!(
        "the page would hold {} MB, more than a browser opens: give the scene a longer `frame_interval`, or write a recording \
         with --record",
        size >> 20
    )))
}

/// The runs of all variants of a scene.
pub(crate) fn prepare(file: &SceneFile) -> Result<Vec<Run>, Refusal> {
    file.scene.variants().iter().map(|variant| Run::new(file, variant).map_err(scene_error)).collect()
}

// By value, as `map_err` gives it.
#[allow(clippy::needless_pass_by_value)]
pub(crate) fn scene_error(error: polhode_scene::SceneError) -> Refusal {
    Refusal::Scene(error.to_string())
}

/// Takes every run to its end, one after the other, under one progress bar.
fn simulate(runs: Vec<Run>, keep: bool) -> Result<Vec<Finished>, Refusal> {
    let bar = Progress::new(runs.iter().map(Run::n_steps).sum());
    let mut finished = Vec::with_capacity(runs.len());
    for mut run in runs {
        bar.say(run.header().label.clone());
        let mut done = 0;
        let mut progress = |steps: u64, _: u64| {
            bar.advance(steps - done);
            done = steps;
            ControlFlow::Continue(())
        };
        let start = Instant::now();
        let recording = if keep {
            run.record(Cursor::new(Vec::new()), &mut progress)?.into_inner()
        } else {
            run.record(io::empty(), &mut progress)?;
            Vec::new()
        };
        let wall = start.elapsed().as_secs_f64();
        let header = run.header();
        let (label, integrator) = (header.label.clone(), header.integrator.clone());
        finished.push(Finished { label, integrator, summary: run.summary(), wall, recording });
    }
    Ok(finished)
}

/// The page of finished recordings.
pub(crate) fn page_of(info: &PageInfo, recordings: &[impl AsRef<[u8]>]) -> Result<String, Refusal> {
    Ok(page(VIEWER, info, recordings)?)
}

/// Runs a scene and returns its page.
pub(crate) fn page_of_scene(file: &SceneFile, info: &PageInfo) -> Result<String, Refusal> {
    let finished = simulate(prepare(file)?, true)?;
    let recordings: Vec<&[u8]> = finished.iter().map(|f| f.recording.as_slice()).collect();
    page_of(info, &recordings)
}

fn summarize(file: &SceneFile, finished: &[Finished], out: &mut dyn Write) -> io::Result<()> {
    let title = if file.scene.title.is_empty() { file.name() } else { &file.scene.title };
    writeln!(out, "{}", styled(HEADING, title))?;
    for run in finished {
        let s = &run.summary;
        let name =
            if run.label == run.integrator { run.label.clone() } else { format!("{}, {}", run.label, run.integrator) };
        writeln!(out, "\n{}", styled(HEADING, &name))?;
        writeln!(
            out,
            "  {} bodies, {} steps to t = {} s, in {:.3} s: {} steps/s",
            s.bodies,
            grouped(s.steps as f64),
            short(s.time),
            run.wall,
            grouped(s.steps as f64 / run.wall.max(1e-9)),
        )?;
        row(out, "change of energy", s.energy_drift, "of E")?;
        row(out, "change of Σ p", s.momentum_drift, "of Σ |p|")?;
        row(out, "change of Σ L", s.angular_momentum_drift, "of |Σ L|, about the origin")?;
        if let Some(error) = s.attitude_error {
            row(out, "attitude error", error, "rad, against the reference")?;
        }
        writeln!(out, "  {:<18}{:#018x}", "state hash", s.hash)?;
        if !s.quarantined.is_empty() {
            writeln!(out, "  a force that was no number was dropped on: {}", s.quarantined.join(", "))?;
        }
        if s.stalled {
            writeln!(out, "  the adaptive step vanished before the end: the motion is not resolved")?;
        }
    }
    writeln!(out)
}

fn row(out: &mut dyn Write, name: &str, value: f64, unit: &str) -> io::Result<()> {
    // Where nothing is conserved there is no scale, and no number.
    if value.is_finite() { writeln!(out, "  {name:<18}{value:<12.2e}{}", styled(FAINT, unit)) } else { Ok(()) }
}

/// A number with at most six decimals, without the zeros behind.
fn short(value: f64) -> String {
    let text = format!("{value:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A whole number in groups of three digits.
fn grouped(value: f64) -> String {
    let digits = format!("{value:.0}");
    let mut text = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// The files to write, opened before the work begins, so that a bad path is told at once.
struct Outputs {
    html: Option<(PathBuf, File)>,
    csv: Vec<(PathBuf, File)>,
    record: Vec<(PathBuf, File)>,
}

impl Outputs {
    fn prepare(arguments: &Arguments, labels: &[String]) -> Result<Self, Refusal> {
        let each = |path: &Option<PathBuf>| -> Result<Vec<(PathBuf, File)>, Refusal> {
            let Some(path) = path else { return Ok(Vec::new()) };
            (0..labels.len()).map(|i| create(of_variant(path, labels, i))).collect()
        };
        Ok(Self {
            html: arguments.html.clone().map(create).transpose()?,
            csv: each(&arguments.csv)?,
            record: each(&arguments.record)?,
        })
    }

    /// Writes the files; returns what each is, and where.
    fn write(self, finished: &[Finished]) -> Result<Vec<(&'static str, PathBuf)>, Refusal> {
        let mut written = Vec::new();
        for ((path, file), run) in self.record.into_iter().zip(finished) {
            save(&path, file, &run.recording)?;
            written.push(("recording", path));
        }
        for ((path, file), run) in self.csv.into_iter().zip(finished) {
            let recording = Recording::read(&run.recording)?;
            let mut to = BufWriter::new(file);
            write_csv(&recording, &mut to).and_then(|()| to.flush()).map_err(|e| unwritable(&path, &e))?;
            written.push(("table", path));
        }
        if let Some((path, file)) = self.html {
            let recordings: Vec<&[u8]> = finished.iter().map(|f| f.recording.as_slice()).collect();
            let page = page_of(&PageInfo::default(), &recordings)?;
            save(&path, file, page.as_bytes())?;
            written.push(("page", path));
        }
        Ok(written)
    }
}

/// `out.csv` for a single run; `out-LABEL.csv` for each of several.
fn of_variant(path: &Path, labels: &[String], i: usize) -> PathBuf {
    if labels.len() == 1 {
        return path.to_path_buf();
    }
    let plain = |c: char| if c.is_alphanumeric() || c == '-' { c } else { '_' };
    let label: String = labels[i].chars().map(plain).collect();
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let end = path.extension().map_or_else(String::new, |e| format!(".{}", e.to_string_lossy()));
    path.with_file_name(format!("{stem}-{label}{end}"))
}

/// Makes a file, and the folders on the way to it.
pub(crate) fn create(path: PathBuf) -> Result<(PathBuf, File), Refusal> {
    if let Some(folder) = path.parent().filter(|f| !f.as_os_str().is_empty()) {
        std::fs::create_dir_all(folder).map_err(|e| unwritable(&path, &e))?;
    }
    let file = File::create(&path).map_err(|e| unwritable(&path, &e))?;
    Ok((path, file))
}

pub(crate) fn save(path: &Path, mut file: File, bytes: &[u8]) -> Result<(), Refusal> {
    file.write_all(bytes).map_err(|e| unwritable(path, &e))
}

fn unwritable(path: &Path, error: &io::Error) -> Refusal {
    Refusal::Input(format!("cannot write {}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn times_are_numbers_or_quotients() {
        assert_eq!(seconds("1/4"), Ok(0.25));
        assert_eq!(seconds("2e-3"), Ok(0.002));
        for wrong in ["", "1/0", "-1", "nan", "x", "1/2/3", "inf"] {
            assert!(seconds(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn numbers_are_grouped() {
        assert_eq!((grouped(1234567.0), grouped(999.0), short(10.0)), ("1,234,567".into(), "999".into(), "10".into()));
    }

    #[test]
    fn variants_get_files_of_their_own() {
        let labels = ["a b".to_owned(), "c".to_owned()];
        assert_eq!(of_variant(Path::new("out/x.csv"), &labels, 0), Path::new("out/x-a_b.csv"));
        assert_eq!(of_variant(Path::new("x"), &labels[..1], 0), Path::new("x"));
    }
}

use std::fs;
use std::path::PathBuf;
use std::sync::{Barrier, Mutex};
use std::thread;

use reuleaux::nalgebra::Vector2;

use crate::run::share;
use crate::{Alone, Checkpoint, POSITIONS, Ranks, Run, Study, Tally, lengths};

const STUDY: Study = Study { seed: 1875, deviation: 0.25e-3, limit: 1.5e-3 };

/// Threads in the place of processes.
struct Threads<'a> {
    rank: usize,
    size: usize,
    barrier: &'a Barrier,
    sum: &'a Mutex<Vec<i64>>,
}

impl Ranks for Threads<'_> {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn sum(&self, words: &mut [i64]) {
        self.sum.lock().expect("no thread panics").resize(words.len(), 0);
        self.barrier.wait();
        self.sum.lock().expect("no thread panics").iter_mut().zip(&*words).for_each(|(sum, word)| *sum += word);
        self.barrier.wait();
        words.copy_from_slice(&self.sum.lock().expect("no thread panics"));
        if self.barrier.wait().is_leader() {
            self.sum.lock().expect("no thread panics").clear();
        }
        self.barrier.wait();
    }
}

fn by_threads(run: &Run, size: usize) -> Tally {
    let (barrier, sum) = (Barrier::new(size), Mutex::new(Vec::new()));
    let mut tallies = thread::scope(|scope| {
        let one = |rank| {
            let ranks = Threads { rank, size, barrier: &barrier, sum: &sum };
            scope.spawn(move || run.on(&ranks, |_| {}).expect("a run"))
        };
        let threads: Vec<_> = (0..size).map(one).collect();
        threads.into_iter().map(|thread| thread.join().expect("a tally")).collect::<Vec<_>>()
    });
    assert!(tallies.windows(2).all(|pair| pair[0] == pair[1]), "every process has the same tally");
    tallies.remove(0)
}

/// A file of its own for each test.
fn file(name: &str) -> PathBuf {
    let path = std::env::temp_dir().join(format!("reuleaux-study-{}-{name}.json", std::process::id()));
    let _ = fs::remove_file(&path);
    path
}

fn run(sets: u64, checkpoint: Option<PathBuf>) -> Run {
    // The interval is so short that there are rounds.
    Run { study: STUDY, sets, checkpoint, interval: 1e-2 }
}

/// A path with a path error of `error` (m).
fn path(error: f64) -> [Vector2<f64>; POSITIONS] {
    let mut path = [Vector2::zeros(); POSITIONS];
    path[7] = Vector2::new(0.0, -error);
    path
}

#[test]
fn tallies_of_adjacent_ranges_add_up() {
    let tally = |range| STUDY.tally(range).expect("a tally");
    let whole = tally(5..403);
    assert_eq!(whole.sets, 398);
    for border in [5, 6, 8, 17, 402] {
        assert_eq!(tally(5..border) + &tally(border..403), whole, "at {border}");
    }
}

#[test]
fn the_number_of_threads_changes_nothing() {
    let alone = STUDY.tally(0..603).expect("a tally");
    for threads in [1, 2, 3, 7] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let all = pool.install(|| STUDY.tally_on_all_processors(0..603, |_| {}).expect("a tally"));
        assert_eq!(all, alone, "{threads} threads");
    }
}

#[test]
fn a_set_can_be_drawn_alone() {
    let [first, again, other] = [42, 42, 43].map(|number| lengths(&STUDY.set(number)));
    assert_eq!(first, again);
    assert!(first.iter().zip(other).all(|(one, other)| *one != other));
    let seeded = lengths(&Study { seed: 1, ..STUDY }.set(42));
    assert!(first.iter().zip(seeded).all(|(one, other)| *one != other));
}

#[test]
fn progress_counts_every_set_once() {
    let count = std::sync::atomic::AtomicU64::new(0);
    let add = |sets| {
        count.fetch_add(sets, std::sync::atomic::Ordering::Relaxed);
    };
    STUDY.tally_on_all_processors(3..1000, add).expect("a tally");
    assert_eq!(count.into_inner(), 997);
}

/// 1, 2, …, 1000 µm: mean 500.5 µm, variance 1000 · 1001 / 12 µm².
#[test]
fn moments_and_quantiles_are_those_of_known_numbers() {
    let mut tally = Tally::default();
    (1..=1000).for_each(|step| tally.count(Some(&path(1e-6 * f64::from(step))), &STUDY));
    tally.count(None, &STUDY);
    assert_eq!((tally.sets, tally.failed, tally.turning(), tally.accepted), (1001, 1, 1000, 1000));
    let deviation = 1e-6 * (1000.0 * 1001.0 / 12.0_f64).sqrt();
    assert!((tally.error.mean(1000) - 500.5e-6).abs() < 1e-14);
    assert!((tally.error.deviation(1000) - deviation).abs() < 1e-13);
    let [x, y] = tally.tips[7];
    assert!(x.mean(1000) == 0.0 && x.deviation(1000) == 0.0);
    assert!((y.mean(1000) + 500.5e-6).abs() < 1e-14 && (y.deviation(1000) - deviation).abs() < 1e-13);
    for (part, expected) in [(0.1, 100e-6), (0.5, 500e-6), (0.95, 950e-6), (1.0, 1000e-6)] {
        let found = tally.quantile(part, &STUDY);
        assert!((found - expected).abs() < 1.001 * STUDY.deviation / 64.0, "{found} for {expected}");
    }
}

#[test]
fn errors_beyond_the_last_interval_are_not_hidden() {
    let mut tally = Tally::default();
    (0..4).for_each(|_| tally.count(Some(&path(0.05)), &STUDY));
    (0..6).for_each(|_| tally.count(Some(&path(0.001)), &STUDY));
    assert_eq!(tally.accepted, 6);
    assert!(tally.quantile(0.5, &STUDY) < 0.0011);
    assert_eq!(tally.quantile(0.7, &STUDY), f64::INFINITY);
}

#[test]
fn words_add_up_as_tallies_do() {
    // Negative sums included, that of y in position 7.
    let mut one = STUDY.tally(0..101).expect("a tally");
    (0..1000).for_each(|_| one.count(Some(&path(0.09)), &STUDY));
    let other = STUDY.tally(101..202).expect("a tally");
    assert_eq!(Tally::from_words(&one.to_words()), one);
    let sum: Vec<i64> = one.to_words().iter().zip(other.to_words()).map(|(one, other)| one + other).collect();
    assert_eq!(Tally::from_words(&sum), one + &other);
}

#[test]
fn shares_follow_each_other() {
    for (left, shares) in [(0..1000, vec![16, 200, 32]), (40..100, vec![16, 200, 32]), (7..9, vec![16, 16]), (8..9, vec![4; 5])] {
        let ranges: Vec<_> = (0..shares.len()).map(|rank| share(left.clone(), &shares, rank)).collect();
        assert_eq!(ranges[0].start, left.start);
        assert!(ranges.windows(2).all(|pair| pair[0].end == pair[1].start), "{ranges:?}");
        let end = left.end.min(left.start + shares.iter().sum::<u64>());
        assert_eq!(ranges[ranges.len() - 1].end, end, "{ranges:?}");
    }
    let sizes = [0, 1, 2].map(|rank| share(0..1_000_000, &[16, 200, 32], rank).count());
    assert_eq!(sizes, [16, 200, 32], "where there is enough, everybody has a share");
}

#[test]
fn the_number_of_processes_changes_nothing() {
    let alone = STUDY.tally(0..1601).expect("a tally");
    assert_eq!(run(1601, None).on(&Alone, |_| {}).expect("a run"), alone);
    for size in [2, 3] {
        assert_eq!(by_threads(&run(1601, None), size), alone, "{size} processes");
    }
}

#[test]
fn a_study_goes_on_from_its_checkpoint_with_other_processes() {
    let [straight, broken] = ["straight", "broken"].map(file);
    run(1600, Some(straight.clone())).on(&Alone, |_| {}).expect("a run");
    by_threads(&run(801, Some(broken.clone())), 3);
    by_threads(&run(1600, Some(broken.clone())), 2);
    let [expected, found] = [&straight, &broken].map(|path| fs::read(path).expect("a checkpoint"));
    assert!(expected == found, "the files are the same, byte for byte");
    // What is done is not done again, nor lost.
    assert_eq!(run(100, Some(broken.clone())).on(&Alone, |_| {}).expect("a run").sets, 1600);
    [straight, broken].iter().for_each(|path| fs::remove_file(path).expect("a file"));
}

#[test]
fn a_checkpoint_that_was_torn_while_written_does_not_count() {
    let path = file("torn");
    run(500, Some(path.clone())).on(&Alone, |_| {}).expect("a run");
    let whole = fs::read(&path).expect("a checkpoint");
    fs::write(path.with_extension("next"), &whole[..whole.len() / 2]).expect("a file");
    assert_eq!(Checkpoint::load(&path, &STUDY).expect("the whole one").sets, 500);
    run(600, Some(path.clone())).on(&Alone, |_| {}).expect("a run");
    assert!(!path.with_extension("next").exists());
    fs::remove_file(path).expect("a file");
}

#[test]
fn a_checkpoint_of_another_study_is_refused() {
    let path = file("other");
    run(100, Some(path.clone())).on(&Alone, |_| {}).expect("a run");
    let before = fs::read(&path).expect("a checkpoint");
    let other = Run { study: Study { seed: 1, ..STUDY }, ..run(200, Some(path.clone())) };
    let refusal = other.on(&Alone, |_| {}).expect_err("another seed").to_string();
    assert!(refusal.contains("belongs to another study"), "{refusal}");
    assert!(fs::read(&path).expect("a checkpoint") == before);

    // Of a declaration that was changed, and of a program that counted less.
    let text = String::from_utf8(before.clone()).expect("JSON");
    for (from, to) in [("\"nominal\":[0.04,", "\"nominal\":[0.041,"), ("\"errors\":[0,", "\"errors\":[")] {
        assert!(text.contains(from), "{from}");
        fs::write(&path, text.replace(from, to)).expect("a file");
        let refusal = run(200, Some(path.clone())).on(&Alone, |_| {}).expect_err(to).to_string();
        assert!(refusal.contains("belongs to another study"), "{refusal}");
    }

    fs::write(&path, &before[..before.len() / 2]).expect("a file");
    let refusal = run(200, Some(path.clone())).on(&Alone, |_| {}).expect_err("half a file").to_string();
    assert!(refusal.contains("is no checkpoint"), "{refusal}");
    fs::remove_file(path).expect("a file");
}

#[test]
fn deviations_are_drawn_from_a_normal_distribution() {
    // Moments of 20000 numbers for each length: mean 0 ± 5/√n, variance 1 ± 5 √(2/n), fourth moment 3 ± 5 √(96/n).
    let (count, nominal) = (20_000_u32, lengths(&crate::Linkage::default()));
    let mut moments = [[0.0; 3]; 6];
    for number in 0..u64::from(count) {
        for (moments, (length, nominal)) in moments.iter_mut().zip(lengths(&STUDY.set(number)).into_iter().zip(nominal)) {
            let z = (length - nominal) / STUDY.deviation;
            for (moment, power) in moments.iter_mut().zip([z, z * z, z * z * z * z]) {
                *moment += power / f64::from(count);
            }
        }
    }
    for [first, second, fourth] in moments {
        let root = f64::from(count).sqrt();
        assert!(first.abs() < 5.0 / root && (second - 1.0).abs() < 5.0 * 2_f64.sqrt() / root, "{first} {second}");
        assert!((fourth - 3.0).abs() < 5.0 * 96_f64.sqrt() / root, "{fourth}");
    }
}

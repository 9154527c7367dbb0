//! The study of tolerances on many machines: as many processes as `mpirun` starts, one to a machine, each on all of its processors.
//!
//! ```sh
//! examples/cluster/run -n 2 -- 10000000 study.json
//! ```
//!
//! `run` starts it, and starts it again where a process is lost; then it goes on from the checkpoint. The result is the same to the last bit
//! whatever the number of processes, and whatever was lost on the way. The first process prints the report, and says on standard error how
//! far the study is.

use std::error::Error;
use std::path::PathBuf;
use std::process::ExitCode;
use std::sync::Mutex;
use std::time::{Duration, Instant};

use mpi::Threading;
use mpi::collective::SystemOperation;
use mpi::topology::SimpleCommunicator;
use mpi::traits::{Communicator, CommunicatorCollectives};
use reuleaux_study::{Ranks, Run, Study};

const USAGE: &str = "usage: reuleaux-cluster SETS CHECKPOINT [SECONDS BETWEEN CHECKPOINTS]";
/// How processes end that need not be started again: what is wrong stays wrong.
const WRONG: u8 = 2;
/// Time between two lines about progress.
const QUIET: Duration = Duration::from_secs(5);

/// All processes that `mpirun` has started.
struct World(SimpleCommunicator);

impl Ranks for World {
    fn rank(&self) -> usize {
        self.0.rank().unsigned_abs() as usize
    }

    fn size(&self) -> usize {
        self.0.size().unsigned_abs() as usize
    }

    fn sum(&self, words: &mut [i64]) {
        let own = words.to_vec();
        self.0.all_reduce_into(&own[..], words, SystemOperation::sum());
    }
}

fn main() -> ExitCode {
    // Other threads solve, this one communicates.
    let Some((_universe, _)) = mpi::initialize_with_threading(Threading::Funneled) else {
        note("MPI is in use already");
        return ExitCode::from(WRONG);
    };
    let world = World(SimpleCommunicator::world());
    let run = wanted().unwrap_or_else(|error| {
        // All processes have the same arguments; the first one says what is wrong with them and ends the others.
        if world.rank() > 0 {
            world.0.barrier();
        }
        give_up(&world, error.as_ref())
    });
    if let Err(error) = study(&run, &world) {
        give_up(&world, error.as_ref());
    }
    ExitCode::SUCCESS
}

fn give_up(world: &World, error: &dyn Error) -> ! {
    note(&error.to_string());
    world.0.abort(WRONG.into())
}

/// Writes a line to standard error in one piece, so that it is not mixed with those of other processes.
fn note(line: &str) {
    let line = format!("{line}\n");
    eprint!("{line}");
}

/// What the arguments ask for.
fn wanted() -> Result<Run, Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let sets = arguments.next().and_then(|sets| sets.parse().ok()).ok_or(USAGE)?;
    let checkpoint = Some(PathBuf::from(arguments.next().ok_or(USAGE)?));
    let interval = arguments.next().map_or(Ok(60.0), |seconds| seconds.parse()).map_err(|_| USAGE)?;
    match arguments.next() {
        None if interval > 0.0 => Ok(Run { study: Study::default(), sets, checkpoint, interval }),
        _ => Err(USAGE.into()),
    }
}

fn study(run: &Run, world: &World) -> Result<(), Box<dyn Error>> {
    note(&format!("rank {} of {} is process {}", world.rank(), world.size(), std::process::id()));
    let (begin, said, is_first) = (Instant::now(), Mutex::new(None), world.rank() == 0);
    let tally = run.on(world, |done| {
        if is_first {
            say(run, done, &said);
        }
    })?;
    if is_first {
        note(&format!("{:.3} s", begin.elapsed().as_secs_f64()));
        print!("{}", run.study.report(&tally)?);
    }
    Ok(())
}

/// Says how many sets are done, if that was not said a moment ago.
fn say(run: &Run, done: u64, said: &Mutex<Option<Instant>>) {
    let Ok(mut said) = said.try_lock() else { return };
    if said.is_none_or(|said| said.elapsed() >= QUIET) {
        *said = Some(Instant::now());
        note(&format!("{done} of {} sets", run.sets));
    }
}

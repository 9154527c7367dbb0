//! Why a loop of rigid links cannot close: one of them is longer than all the others together.
//!
//! In: [`Link`]s. Out: a [`Bound`], where there is one. In any loop a link, a rod or the distance between two fixed places must not
//! be longer than the shortest way between its ends over other links. Whatever else a mechanism demands, this is necessary; for a
//! single loop of revolutes it is also sufficient.
//!
//! Reference for the shortest way: Dijkstra (1959), A note on two problems in connexion with graphs.

use super::links::{BodyPoint, Link};
use crate::diag::Bound;
use crate::numeric::Numeric;
use std::collections::BTreeMap;

/// With more places than this the search for a bound would be felt.
const MOST: usize = 120;

/// What is missing must be more than this part of the length.
const CLEARLY: f64 = 1e-9;

/// The link that is longest for the others. Bodies that are not `moving` stand still, all together.
pub(super) fn longest(numeric: &Numeric, links: &[Link], moving: &dyn Fn(usize) -> bool, is_always: bool) -> Option<Bound> {
    let graph = Graph::new(numeric, links, moving)?;
    let mut worst: Option<Bound> = None;
    for span in graph.spans() {
        let Some(ways) = graph.shortest(&span) else { continue };
        let bound = Bound { ways, span: (span.name.clone(), span.length), is_always };
        let missing = bound.missing();
        if missing > CLEARLY * span.length && worst.as_ref().is_none_or(|worst| missing > worst.missing() * (1.0 + CLEARLY)) {
            worst = Some(bound);
        }
    }
    worst
}

/// A connection of two nodes.
#[derive(Clone, Debug)]
struct Edge {
    ends: [usize; 2],
    length: f64,
    name: String,
    /// What it is a part of: ways over the same thing do not count.
    owner: Owner,
    /// It is only a bound from below, as the distance from a line.
    is_span_only: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Owner {
    Body(Option<usize>),
    Rod(usize),
}

struct Graph {
    nodes: usize,
    edges: Vec<Edge>,
}

impl Graph {
    fn new(numeric: &Numeric, links: &[Link], moving: &dyn Fn(usize) -> bool) -> Option<Graph> {
        let group = |place: &BodyPoint| place.body.filter(|body| moving(*body));
        let places: Vec<BodyPoint> = links
            .iter()
            .flat_map(|link| match link {
                Link::Pin(one, other) | Link::Rod(one, other, _) => vec![*one, *other],
                Link::Line(place, ..) => vec![*place],
            })
            .collect();
        if places.len() > 2 * MOST {
            return None;
        }
        // Places of one body that coincide are one node, and so are the two of a pin.
        let mut node: Vec<usize> = (0..places.len()).collect();
        let mut unite = |one: usize, other: usize| {
            let (one, other) = (node[one].min(node[other]), node[one].max(node[other]));
            node.iter_mut().filter(|node| **node == other).for_each(|node| *node = one);
        };
        for (i, one) in places.iter().enumerate() {
            for (j, other) in places.iter().enumerate().skip(i + 1) {
                if group(one) == group(other) && apart(one.at, other.at) <= CLEARLY * numeric.size {
                    unite(i, j);
                }
            }
        }
        let mut next = 0;
        for link in links {
            if let Link::Pin(..) = link {
                unite(next, next + 1);
            }
            next += if let Link::Line(..) = link { 1 } else { 2 };
        }
        let mut of_group: BTreeMap<Option<usize>, Vec<usize>> = BTreeMap::new();
        places.iter().enumerate().for_each(|(index, place)| of_group.entry(group(place)).or_default().push(index));
        let mut edges: Vec<Edge> = Vec::new();
        for (owner, members) in &of_group {
            for (count, i) in members.iter().enumerate() {
                for j in &members[count + 1..] {
                    let (one, other) = (&places[*i], &places[*j]);
                    if node[*i] != node[*j] {
                        let (ends, length) = ([node[*i], node[*j]], apart(one.at, other.at));
                        edges.push(Edge { ends, length, name: name(numeric, one, other), owner: Owner::Body(*owner), is_span_only: false });
                    }
                }
            }
        }
        let mut next = 0;
        for link in links {
            match link {
                Link::Rod(place, _, length) => {
                    let name = format!("`{}`", numeric.model.joints[place.joint].name);
                    let ends = [node[next], node[next + 1]];
                    edges.push(Edge { ends, length: *length, name, owner: Owner::Rod(place.joint), is_span_only: false });
                }
                Link::Line(place, n, c) => {
                    for fixed in of_group.get(&None).into_iter().flatten().filter(|fixed| node[**fixed] != node[next]) {
                        let at = places[*fixed].at;
                        let length = (n[0] * at[0] + n[1] * at[1] - c).abs();
                        let [joint, line] = [places[*fixed].joint, place.joint].map(|joint| &numeric.model.joints[joint].name);
                        let name = format!("the distance of `{joint}` from the line of `{line}`");
                        let ends = [node[*fixed], node[next]];
                        edges.push(Edge { ends, length, name, owner: Owner::Body(None), is_span_only: true });
                    }
                }
                Link::Pin(..) => {}
            }
            next += if let Link::Line(..) = link { 1 } else { 2 };
        }
        (edges.len() <= MOST * MOST / 2).then_some(Graph { nodes: places.len(), edges })
    }

    /// What may be too long.
    fn spans(&self) -> impl Iterator<Item = Edge> {
        self.edges.clone().into_iter().filter(|edge| edge.length > 0.0)
    }

    /// The shortest way between the ends of a span over anything else.
    fn shortest(&self, span: &Edge) -> Option<Vec<(String, f64)>> {
        let mut reached: Vec<Option<(f64, Option<usize>)>> = vec![None; self.nodes];
        let mut is_done = vec![false; self.nodes];
        reached[span.ends[0]] = Some((0.0, None));
        loop {
            let open = (0..self.nodes).filter(|node| !is_done[*node]).filter_map(|node| reached[node].map(|(length, _)| (length, node)));
            let (length, node) = open.min_by(|one, other| one.0.total_cmp(&other.0))?;
            if node == span.ends[1] {
                break;
            }
            is_done[node] = true;
            for (index, edge) in self.edges.iter().enumerate().filter(|(_, edge)| edge.owner != span.owner && !edge.is_span_only) {
                let Some(end) = edge.ends.iter().position(|end| *end == node) else { continue };
                let far = edge.ends[1 - end];
                if reached[far].is_none_or(|(known, _)| length + edge.length < known) {
                    reached[far] = Some((length + edge.length, Some(index)));
                }
            }
        }
        let mut ways = Vec::new();
        let mut node = span.ends[1];
        while let Some((_, Some(index))) = reached[node] {
            let edge = &self.edges[index];
            ways.push((edge.name.clone(), edge.length));
            node = if edge.ends[0] == node { edge.ends[1] } else { edge.ends[0] };
        }
        ways.reverse();
        Some(ways)
    }
}

fn apart(one: [f64; 2], other: [f64; 2]) -> f64 {
    (one[0] - other[0]).hypot(one[1] - other[1])
}

/// `crank`, `ground`, or where two places are of different bodies that stand still, what lies between their joints.
fn name(numeric: &Numeric, one: &BodyPoint, other: &BodyPoint) -> String {
    match (one.body, other.body) {
        (Some(body), Some(same)) if body == same => format!("`{}`", numeric.model.bodies[body].name),
        (None, None) => "`ground`".to_owned(),
        _ => {
            let [one, other] = [one.joint, other.joint].map(|joint| &numeric.model.joints[joint].name);
            format!("the distance from `{one}` to `{other}`")
        }
    }
}

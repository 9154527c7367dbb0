//! Proof that a loop of rigid links cannot close: one link is longer than all others together.
//!
//! In: [`Link`]s. Out: a [`Bound`], if there is one. In any loop, a body, a rod or the distance between two fixed points must not be longer
//! than the shortest path between its ends over other links. This is necessary for every mechanism, and sufficient for a single loop of
//! revolutes.
//!
//! Reference for the shortest path: Dijkstra (1959), A note on two problems in connexion with graphs.

use super::links::{BodyPoint, Link};
use crate::diag::Bound;
use crate::numeric::Numeric;
use std::collections::BTreeMap;

/// Limit of the graph: at most twice as many points, and half its square of edges; beyond it, compilation would slow down noticeably.
const MOST: usize = 120;

/// The shortfall must exceed this fraction of the length.
const CLEARLY: f64 = 1e-9;

/// The link with the largest shortfall. Bodies that are not `moving` are fixed to each other.
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

/// An edge between two nodes.
#[derive(Clone, Debug)]
struct Edge {
    ends: [usize; 2],
    length: f64,
    name: String,
    /// Rigid part of the edge: paths over the same part do not count.
    owner: Owner,
    /// True if the length is only a lower bound, as the distance from a line is.
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
        // Coincident points of one body are one node, and so are the two points of a pin.
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

    /// Edges that may be too long.
    fn spans(&self) -> impl Iterator<Item = Edge> {
        self.edges.clone().into_iter().filter(|edge| edge.length > 0.0)
    }

    /// Shortest path between the ends of an edge over other parts.
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

/// Name of an edge: `crank`, `ground`, or the distance between two joints if the points belong to different fixed bodies.
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

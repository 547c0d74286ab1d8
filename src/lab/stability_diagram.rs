//! How the regions of stability look, and their edges as CSV, with their limits on the rays of a swing and of drag alone.

use super::rows::{shortest, table};
use super::stability::Region;
use crate::draw::chart::look::{CurveLook, CurveOrigin};

pub const SVG: &str = "stability.svg";
pub const TITLE: &str = "Where methods are stable: the plane of z = h·λ";

pub fn look(index: usize) -> CurveLook {
    CurveLook::of(index, CurveOrigin::Lab)
}

pub fn shipped_look() -> CurveLook {
    CurveLook::of(0, CurveOrigin::Shipped)
}

/// Two files: the edges, point by point, and the limits on the two rays.
pub fn csv(regions: &[Region]) -> [(&'static str, String); 2] {
    let points = regions.iter().flat_map(|region| {
        region.edge.iter().enumerate().flat_map(move |(piece, line)| {
            line.iter().map(move |(re, im)| vec![region.name.to_owned(), piece.to_string(), shortest(*re), shortest(*im)])
        })
    });
    let limits = regions.iter().map(|region| vec![region.name.to_owned(), shortest(region.drag), shortest(region.swing)]);
    [
        ("stability.csv", table(&["method", "piece", "re", "im"], points)),
        ("stability-limits.csv", table(&["method", "drag_alone", "swing"], limits)),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::lab::stability::regions;

    #[test]
    fn the_files_name_every_method_and_hold_every_edge() {
        let regions = regions();
        let [(_, edges), (_, limits)] = csv(&regions);
        for region in &regions {
            assert!(limits.contains(&format!("\n{},", quoted(region.name))), "{}", region.name);
            let points = edges.lines().filter(|line| line.starts_with(&format!("{},", quoted(region.name)))).count();
            assert_eq!(points, region.edge.iter().map(Vec::len).sum::<usize>());
            assert!(points > 50, "{}", region.name);
        }
    }

    fn quoted(name: &str) -> String {
        if name.contains(',') { format!("\"{name}\"") } else { name.to_owned() }
    }
}

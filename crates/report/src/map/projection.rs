use crate::axis::decade;
use crate::svg::Rounded;
use pairtrawl_geometry::{Bounds, Point};
use pairtrawl_model::SceneOutline;
use pairtrawl_model::numbers::LengthUnit;

/// The part of the floor that is drawn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// Lower left corner, m.
    pub min: Point,
    /// Upper right corner, m.
    pub max: Point,
}

impl View {
    /// The area and as much around it as a robot at its border needs. Of a ROS map, which may be blocked far and wide,
    /// only the part with free cells.
    pub fn of(outline: &SceneOutline) -> Self {
        let area = Bounds {
            min: outline.area.min,
            max: outline.area.max,
        };
        let pairs = [outline.start, outline.end];
        let robots = pairs
            .iter()
            .flat_map(|p| [p.left.position(), p.right.position()]);
        let free = outline.free_rings.iter().flatten().flatten().copied();
        let used = match outline.free_rings {
            Some(_) => Bounds::of(&free.chain(robots).collect::<Vec<_>>()),
            None => area,
        };
        let view =
            used.grown(outline.robot.circles().reach() + 0.02 * (used.max - used.min).norm());
        Self {
            min: view.min,
            max: view.max,
        }
    }

    pub fn width(&self) -> f64 {
        self.max.x - self.min.x
    }

    pub fn height(&self) -> f64 {
        self.max.y - self.min.y
    }

    /// The unit of its axes.
    pub fn unit(&self) -> LengthUnit {
        LengthUnit::of(self.width().max(self.height()))
    }
}

/// From the map frame to the coordinates of a drawing.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Projection {
    origin: Point,
    scale: f64,
    /// 1: y up as in the map frame; -1: y down as on a screen.
    up: f64,
    decimals: usize,
}

impl Projection {
    /// To pixels, y down: the view's upper left corner comes to lie at `corner`.
    pub fn pixels(view: &View, scale: f64, corner: Point) -> Self {
        Self {
            origin: Point::new(corner.x - scale * view.min.x, corner.y + scale * view.max.y),
            scale,
            up: -1.0,
            decimals: 2,
        }
    }

    /// To meters as they are, y up, to better than a hundredth of a robot: for a group that is transformed as a whole.
    pub fn meters(robot_radius: f64) -> Self {
        Self {
            origin: Point::ZERO,
            scale: 1.0,
            up: 1.0,
            decimals: usize::try_from(2 - decade(robot_radius)).unwrap_or(0),
        }
    }

    pub fn x(&self, x: f64) -> Rounded {
        Rounded(self.origin.x + self.scale * x, self.decimals)
    }

    pub fn y(&self, y: f64) -> Rounded {
        Rounded(self.origin.y + self.up * self.scale * y, self.decimals)
    }

    /// As [`Self::x`], and so far to the right of it.
    pub fn x_offset(&self, x: f64, offset: f64) -> Rounded {
        Rounded(self.x(x).0 + offset, self.decimals)
    }

    /// As [`Self::y`], and so far below it on a screen.
    pub fn y_offset(&self, y: f64, offset: f64) -> Rounded {
        Rounded(self.y(y).0 + offset, self.decimals)
    }

    pub fn length(&self, length: f64) -> Rounded {
        Rounded(self.scale * length, self.decimals)
    }

    /// Path data of a polyline; points that are not finite are left out.
    pub fn path(&self, points: impl IntoIterator<Item = Point>) -> String {
        let mut d = String::new();
        for p in points.into_iter().filter(|p| p.is_finite()) {
            d.push(if d.is_empty() { 'M' } else { 'L' });
            d.push_str(&format!("{} {}", self.x(p.x), self.y(p.y)));
        }
        d
    }

    /// Path data of a closed ring.
    pub fn ring(&self, points: impl IntoIterator<Item = Point>) -> String {
        let mut d = self.path(points);
        if !d.is_empty() {
            d.push('Z');
        }
        d
    }
}

//! Membership functions over numbers, as the kernel computes them.

use crate::base::Exact;
use crate::ir::{Part, Shape};
use crate::kernel;

/// From a value, in SI, to its degree of membership.
pub(crate) type Function = Box<dyn Fn(f64) -> f64>;

/// The same from a value and the degrees of earlier parts.
type Built = Box<dyn Fn(f64, &[f64]) -> f64>;

/// The membership function of a set of an output.
pub(crate) fn function(shape: &Shape) -> Function {
    let Shape::Built(parts) = shape else { return plain(shape) };
    let built = |part: &Part| -> Built {
        match part.clone() {
            Part::Shape(shape) => {
                let function = plain(&shape);
                Box::new(move |x, _| function(x))
            }
            Part::Not(of) => Box::new(move |_, degrees| 1.0 - degrees[of as usize]),
            Part::Very(of) => Box::new(move |_, degrees| kernel::very(degrees[of as usize])),
            Part::Somewhat(of) => Box::new(move |_, degrees| kernel::somewhat(degrees[of as usize])),
            Part::All(of) => {
                Box::new(move |_, degrees| of.iter().map(|&of| degrees[of as usize]).fold(1.0, kernel::minimum))
            }
            Part::Any(of) => {
                Box::new(move |_, degrees| of.iter().map(|&of| degrees[of as usize]).fold(0.0, kernel::maximum))
            }
        }
    };
    let parts: Vec<_> = parts.iter().map(built).collect();
    Box::new(move |x| {
        let mut degrees: Vec<f64> = Vec::with_capacity(parts.len());
        for part in &parts {
            degrees.push(part(x, &degrees));
        }
        degrees.last().copied().unwrap_or(0.0)
    })
}

fn plain(shape: &Shape) -> Function {
    let f = Exact::to_f64;
    match *shape {
        Shape::Triangle(corners) => {
            let [a, b, c] = corners.map(f);
            Box::new(move |x| kernel::triangle(x, a, b, c))
        }
        Shape::Trapezoid(corners) => {
            let [a, b, c, d] = corners.map(f);
            Box::new(move |x| kernel::trapezoid(x, a, b, c, d))
        }
        Shape::Ramp { zero_at, one_at } => {
            let (zero_at, one_at) = (f(zero_at), f(one_at));
            Box::new(move |x| kernel::ramp(x, zero_at, one_at))
        }
        Shape::Rectangle(ends) => {
            let [low, high] = ends.map(f);
            Box::new(move |x| kernel::rectangle(x, low, high))
        }
        Shape::Singleton(at) => {
            let at = f(at);
            Box::new(move |x| kernel::singleton(x, at))
        }
        Shape::Points(ref points) => {
            let points: Vec<_> = points.iter().map(|(at, degree)| (f(*at), f(*degree))).collect();
            Box::new(move |x| kernel::points(x, &points))
        }
        Shape::Gaussian(of) => {
            let [mean, deviation] = of.map(f);
            Box::new(move |x| kernel::gaussian(x, mean, deviation))
        }
        Shape::Gaussian2(of) => {
            let [low, below, high, above] = of.map(f);
            Box::new(move |x| kernel::gaussian2(x, low, below, high, above))
        }
        Shape::Bell(of) => {
            let [center, width, slope] = of.map(f);
            Box::new(move |x| kernel::bell(x, center, width, slope))
        }
        Shape::Sigmoid(of) => {
            let [inflection, slope] = of.map(f);
            Box::new(move |x| kernel::sigmoid(x, inflection, slope))
        }
        Shape::Rise(of) => {
            let [a, b] = of.map(f);
            Box::new(move |x| kernel::rise(x, a, b))
        }
        Shape::Fall(of) => {
            let [a, b] = of.map(f);
            Box::new(move |x| kernel::fall(x, a, b))
        }
        Shape::RiseAndFall(corners) => {
            let [a, b, c, d] = corners.map(f);
            Box::new(move |x| kernel::rise_and_fall(x, a, b, c, d))
        }
        Shape::Cosine(of) => {
            let [center, width] = of.map(f);
            Box::new(move |x| kernel::cosine(x, center, width))
        }
        // Only a term is built, not its parts.
        Shape::Built(_) => Box::new(|_| 0.0),
    }
}

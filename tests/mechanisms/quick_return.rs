//! `quick_return.json`

use crate::declared;

declared! {
    /// Whitworth's quick-return mechanism with Haug's data.
    QuickReturn (crank_length: Length = 1.5, link: Length = 2.5298, speed: AngularVelocity = 1) {
        ground { point O = (0, 0);  point C = (0, 2);  point T = (0, 4);  axis along = (1, 0); }
        body bar {
            point O = (-2, 0);  point M = (0, 0);  point E = (2, 0);  axis along = (1, 0);
            start position = (1.2, 1.6);  start angle = 0.927;
        }
        body crank  { point C = (0, 0);   point K = (crank_length, 0);  start angle = 0; }
        body key    { point K = (0, 0);   start angle = 0.927; }
        body cutter { point T = (0, 0);   axis along = (1, 0);  start position = (0, 4);  start angle = 0; }
        joint o = revolute(bar.O, ground.O);
        joint c = revolute(crank.C, ground.C);
        joint k = revolute(crank.K, key.K);
        joint slot = translational(bar.along, bar.M, key.K);
        joint guide = translational(cutter.along, cutter.T, ground.T);
        joint coupler = distance(bar.E, cutter.T, link);
        drive motor = drive_relative_angle(ground, crank, speed * t);
    } outputs QuickReturnState {
        interest = [bar.E];
        cut = [cutter.x];
    }
}

reuleaux::mechanism! {
    pub mechanism Crank {
        body crank { point A = (100mm, 0mm); }
        joint hinge = revolute((0mm, 0mm), crank.position);
        drive input = drive_angle(crank, 60rpm * t);
        output tip = crank.A;
        component C0(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C1(bar.end); }
        component C1(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C2(bar.end); }
        component C2(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C3(bar.end); }
        component C3(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C4(bar.end); }
        component C4(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C5(bar.end); }
        component C5(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C6(bar.end); }
        component C6(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C7(bar.end); }
        component C7(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C8(bar.end); }
        component C8(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C9(bar.end); }
        component C9(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C10(bar.end); }
        component C10(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C11(bar.end); }
        component C11(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C12(bar.end); }
        component C12(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C13(bar.end); }
        component C13(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C14(bar.end); }
        component C14(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C15(bar.end); }
        component C15(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C16(bar.end); }
        component C16(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C17(bar.end); }
        component C17(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C18(bar.end); }
        component C18(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C19(bar.end); }
        component C19(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C20(bar.end); }
        component C20(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C21(bar.end); }
        component C21(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C22(bar.end); }
        component C22(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C23(bar.end); }
        component C23(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); part next = C24(bar.end); }
        component C24(root: Point) { body bar { point end = (1m, 0m); } joint w = weld(root, bar.position); }
        part first = C0(crank.A);
    }
}

fn main() {
    let mechanism = Crank::default();
    let state = mechanism.solve(0.5).unwrap();
    let _ = [mechanism.tip(&state).value.x, state.crank().angle];
}

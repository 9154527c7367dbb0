chain! {
    Chain, ChainState, "W4 chain of 10", 10, absolute by Static, first r0, last r10,
    0m r0 c0 r1 1m a0 b0 p1;  1m r1 c1 r2 2m a1 b1 p2;
    2m r2 c2 r3 3m a2 b2 p3;  3m r3 c3 r4 4m a3 b3 p4;
    4m r4 c4 r5 5m a4 b4 p5;  5m r5 c5 r6 6m a5 b5 p6;
    6m r6 c6 r7 7m a6 b6 p7;  7m r7 c7 r8 8m a7 b7 p8;
    8m r8 c8 r9 9m a8 b8 p9;  9m r9 c9 r10 10m a9 b9 p10;
}

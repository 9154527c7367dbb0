chain! {
    Chain, ChainState, "W4 chain of 40", 40, absolute by Dynamic, first r0, last r40,
    0m r0 c0 r1 1m a0 b0 p1;  1m r1 c1 r2 2m a1 b1 p2;
    2m r2 c2 r3 3m a2 b2 p3;  3m r3 c3 r4 4m a3 b3 p4;
    4m r4 c4 r5 5m a4 b4 p5;  5m r5 c5 r6 6m a5 b5 p6;
    6m r6 c6 r7 7m a6 b6 p7;  7m r7 c7 r8 8m a7 b7 p8;
    8m r8 c8 r9 9m a8 b8 p9;  9m r9 c9 r10 10m a9 b9 p10;
    10m r10 c10 r11 11m a10 b10 p11;  11m r11 c11 r12 12m a11 b11 p12;
    12m r12 c12 r13 13m a12 b12 p13;  13m r13 c13 r14 14m a13 b13 p14;
    14m r14 c14 r15 15m a14 b14 p15;  15m r15 c15 r16 16m a15 b15 p16;
    16m r16 c16 r17 17m a16 b16 p17;  17m r17 c17 r18 18m a17 b17 p18;
    18m r18 c18 r19 19m a18 b18 p19;  19m r19 c19 r20 20m a19 b19 p20;
    20m r20 c20 r21 21m a20 b20 p21;  21m r21 c21 r22 22m a21 b21 p22;
    22m r22 c22 r23 23m a22 b22 p23;  23m r23 c23 r24 24m a23 b23 p24;
    24m r24 c24 r25 25m a24 b24 p25;  25m r25 c25 r26 26m a25 b25 p26;
    26m r26 c26 r27 27m a26 b26 p27;  27m r27 c27 r28 28m a27 b27 p28;
    28m r28 c28 r29 29m a28 b28 p29;  29m r29 c29 r30 30m a29 b29 p30;
    30m r30 c30 r31 31m a30 b30 p31;  31m r31 c31 r32 32m a31 b31 p32;
    32m r32 c32 r33 33m a32 b32 p33;  33m r33 c33 r34 34m a33 b33 p34;
    34m r34 c34 r35 35m a34 b34 p35;  35m r35 c35 r36 36m a35 b35 p36;
    36m r36 c36 r37 37m a36 b36 p37;  37m r37 c37 r38 38m a37 b37 p38;
    38m r38 c38 r39 39m a38 b38 p39;  39m r39 c39 r40 40m a39 b39 p40;
}

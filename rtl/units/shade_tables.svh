    // Printed from datapath/numbers/power.cpp: log2(1 + u) and 2^-f in pieces.
    /* verilator lint_off UNUSEDPARAM */

    localparam [61:0] LOG_1 = {
        31'h4ae6a47a, 31'h00095cf1
    };

    localparam [147:0] LOG_2 = {
        37'h19d63150d2, 37'h12b838f118, 37'h0a4d435989, 37'h0000526a4c
    };

    localparam [343:0] LOG_3 = {
        43'h741517d618a, 43'h6757997b1c1, 43'h59a81b5f206, 43'h4ae01d9025e, 43'h3acee022acb, 43'h29352333b59,
        43'h15c026ea419, 43'h00002b80520
    };

    localparam [783:0] LOG_4 = {
        49'h1e88c6bb9d2fb, 49'h1d0540c1c332d, 49'h1b7494c856365, 49'h19d5dacf5d3a4, 49'h18280ad6e83e8, 49'h166a00df05436,
        49'h149a78e7c448c, 49'h12b804f13a4ec, 49'h10c106fb7f558, 49'h0eb3ab06ae5d5, 49'h0c8ddf12e6664, 49'h0a4d3d2051708,
        49'h07ef072f1b7c6, 49'h0570073f808a3, 49'h02cc7f51c49a8, 49'h000001663fadc
    };

    localparam [1471:0] LOG_5 = {
        46'h3e8bc17440bc, 46'h3d118d7a34c3, 46'h3b91358058c8, 46'h3a0a8186b4ce, 46'h387d398d48d6, 46'h36e9299410de,
        46'h354e119b18e6, 46'h33abb5a25cee, 46'h3201cda9e8f6, 46'h305015b1b8ff, 46'h2e9641b9d508, 46'h2cd401c24113,
        46'h2b0905cafd1e, 46'h2934f1d41529, 46'h275769dd8935, 46'h257009e76141, 46'h237e65f1a54e, 46'h21820dfc595c,
        46'h1f7a8607896d, 46'h1d675613317f, 46'h1b47ee1f6990, 46'h191bbe2c31a2, 46'h16e222399db7, 46'h149a7a47a9ce,
        46'h12440a5671e5, 46'h0fde0e65fdfe, 46'h0d67b2765e19, 46'h0ae00e87a638, 46'h08462e99e259, 46'h0598fead327d,
        46'h02d75ec1a2a2, 46'h000002d75ecb
    };

    localparam [79:0] EXP_1 = {
        40'h5a827b504f, 40'h800004afb1
    };

    localparam [155:0] EXP_2 = {
        39'h260dfd837f, 39'h2d413dccd0, 39'h35d1422401, 39'h4000028bb0
    };

    localparam [303:0] EXP_3 = {
        38'h1172b8b95c, 38'h1306feca23, 38'h14bfdadc6e, 38'h16a09ef062, 38'h18ace70624, 38'h1ae8a11ddd,
        38'h1d581937bc, 38'h20000153f4
    };

    localparam [591:0] EXP_4 = {
        37'h085aac5aac, 37'h08b95c5eb0, 37'h091c3d62e1, 37'h09837f6742, 37'h09ef536bd4, 37'h0a5fed709a,
        37'h0ad5847597, 37'h0b504f7acb, 37'h0bd08a803b, 37'h0c567385e9, 37'h0ce2498bd6, 37'h0d74509207,
        37'h0e0cce987e, 37'h0eac0c9f3e, 37'h0f5258a64c, 37'h100000ada8
    };

    localparam [1151:0] EXP_5 = {
        36'h4166c2cd8, 36'h42d562dd4, 36'h444c0aed5, 36'h45cae2fdb, 36'h4752230e8, 36'h48e1eb1f9,
        36'h4a7a7b312, 36'h4c1bfb430, 36'h4dc6a3555, 36'h4f7a9b67f, 36'h5138237b1, 36'h52ff6b8e9,
        36'h54d0b3a29, 36'h56ac23b6e, 36'h5891fbcbb, 36'h5a827be10, 36'h5c7ddbf6c, 36'h5e84540cf,
        36'h60962c23b, 36'h62b39c3ae, 36'h64dce4529, 36'h67124c6ad, 36'h695414839, 36'h6ba2849ce,
        36'h6dfddcb6b, 36'h706674d13, 36'h72dc84ec2, 36'h75606507c, 36'h77f265240, 36'h7a92c540c,
        36'h7d41dd5e3, 36'h8000057c5
    };

    localparam [2239:0] EXP_6 = {
        35'h20593564d, 35'h20b36168b, 35'h210e8d6cb, 35'h216ab1709, 35'h21c7d974a, 35'h22260578b,
        35'h2285357cc, 35'h22e57180f, 35'h2346b9852, 35'h23a911896, 35'h240c798da, 35'h2470f591f,
        35'h24d68d966, 35'h253d3d9ac, 35'h25a50d9f4, 35'h260dfda3c, 35'h267811a85, 35'h26e351ad0,
        35'h274fb9b1a, 35'h27bd4db65, 35'h282c15bb2, 35'h289c11bff, 35'h290d45c4d, 35'h297fb5c9c,
        35'h29f365cec, 35'h2a6859d3d, 35'h2ade91d8e, 35'h2b5611de0, 35'h2bcee1e34, 35'h2c48fde87,
        35'h2cc471edd, 35'h2d413df33, 35'h2dbf65f8a, 35'h2e3eedfe2, 35'h2ebfda03b, 35'h2f422a094,
        35'h2fc5ea0f0, 35'h304b1614b, 35'h30d1b61a8, 35'h3159ce206, 35'h31e35e264, 35'h326e722c5,
        35'h32fb06325, 35'h338926388, 35'h3418ce3ea, 35'h34aa0a44f, 35'h353cda4b4, 35'h35d14251a,
        35'h366746581, 35'h36feee5ea, 35'h37983e654, 35'h38333a6bf, 35'h38cfe672b, 35'h396e42797,
        35'h3a0e5e807, 35'h3ab032875, 35'h3b53ce8e7, 35'h3bf932959, 35'h3ca05e9cb, 35'h3d4962a41,
        35'h3df43aab6, 35'h3ea0eeb2d, 35'h3f4f86ba6, 35'h400002c1f
    };

    localparam [4351:0] EXP_7 = {
        34'h10163eb1f, 34'h102c9ab2e, 34'h104316b3e, 34'h1059b0b4d, 34'h10706cb5e, 34'h108746b6d,
        34'h109e3eb7c, 34'h10b558b8d, 34'h10cc92b9d, 34'h10e3ecbad, 34'h10fb66bbd, 34'h111302bce,
        34'h112abebde, 34'h11429abee, 34'h115a98bff, 34'h1172b8c10, 34'h118afac21, 34'h11a35cc31,
        34'h11bbe0c42, 34'h11d488c54, 34'h11ed50c64, 34'h12063cc76, 34'h121f4ac87, 34'h12387ac98,
        34'h1251cecaa, 34'h126b46cbc, 34'h1284e0ccd, 34'h129e9ecdf, 34'h12b880cf1, 34'h12d286d03,
        34'h12ecb0d15, 34'h1306fed27, 34'h132170d39, 34'h133c08d4c, 34'h1356c6d5f, 34'h1371a8d71,
        34'h138caed83, 34'h13a7dcd97, 34'h13c32eda9, 34'h13dea6dbc, 34'h13fa46dd0, 34'h14160ade2,
        34'h1431f6df6, 34'h144e08e09, 34'h146a42e1d, 34'h1486a2e30, 34'h14a32ae44, 34'h14bfdae58,
        34'h14dcb2e6c, 34'h14f9b2e80, 34'h1516dae94, 34'h15342cea9, 34'h1551a4ebc, 34'h156f48ed2,
        34'h158d12ee5, 34'h15ab08efb, 34'h15c926f0f, 34'h15e770f25, 34'h1605e2f39, 34'h16247ef4e,
        34'h164346f64, 34'h166238f79, 34'h168156f8f, 34'h16a09efa4, 34'h16c012fba, 34'h16dfb2fd0,
        34'h16ff7efe6, 34'h171f76ffc, 34'h173f9b012, 34'h175fed029, 34'h17806b03f, 34'h17a115055,
        34'h17c1ef06d, 34'h17e2f5083, 34'h18042909a, 34'h18258b0b1, 34'h18471b0c8, 34'h1868db0e0,
        34'h188ac90f7, 34'h18ace710f, 34'h18cf33126, 34'h18f1af13e, 34'h19145d157, 34'h19373916e,
        34'h195a45186, 34'h197d8319f, 34'h19a0f31b8, 34'h19c4931d0, 34'h19e8651e9, 34'h1a0c67201,
        34'h1a309d21b, 34'h1a5505234, 34'h1a799f24d, 34'h1a9e6d267, 34'h1ac36d280, 34'h1ae8a129a,
        34'h1b0e092b4, 34'h1b33a32cd, 34'h1b59732e8, 34'h1b7f77302, 34'h1ba5b131d, 34'h1bcc1f337,
        34'h1bf2c3352, 34'h1c199d36d, 34'h1c40ad388, 34'h1c67f33a3, 34'h1c8f6f3be, 34'h1cb7213d9,
        34'h1cdf0d3f6, 34'h1d072f411, 34'h1d2f8942d, 34'h1d5819448, 34'h1d80e5466, 34'h1da9e7481,
        34'h1dd32349e, 34'h1dfc994bb, 34'h1e26474d7, 34'h1e502f4f4, 34'h1e7a53512, 34'h1ea4b152f,
        34'h1ecf4954c, 34'h1efa1d56a, 34'h1f252d588, 34'h1f50775a5, 34'h1f7bff5c4, 34'h1fa7c35e2,
        34'h1fd3c3600, 34'h20000161f
    };

    localparam [8447:0] EXP_8 = {
        33'h08058d58d, 33'h080b1f592, 33'h0810b4595, 33'h08164d599, 33'h081bea59d, 33'h08218b5a1,
        33'h0827305a5, 33'h082cd85a8, 33'h0832855ad, 33'h0838365b1, 33'h083dea5b4, 33'h0843a35b9,
        33'h08495f5bc, 33'h084f1f5c0, 33'h0854e45c5, 33'h085aac5c8, 33'h0860795cd, 33'h0866495d0,
        33'h086c1e5d5, 33'h0871f65d8, 33'h0877d35dd, 33'h087db35e0, 33'h0883985e5, 33'h0889815e9,
        33'h088f6e5ed, 33'h08955f5f1, 33'h089b545f5, 33'h08a14d5f9, 33'h08a74b5fe, 33'h08ad4c601,
        33'h08b352606, 33'h08b95c60a, 33'h08bf6a60e, 33'h08c57d613, 33'h08cb93616, 33'h08d1ae61b,
        33'h08d7cd61f, 33'h08ddf0623, 33'h08e418628, 33'h08ea4462c, 33'h08f074630, 33'h08f6a8634,
        33'h08fce1639, 33'h09031e63d, 33'h09095f641, 33'h090fa5646, 33'h0915ef64a, 33'h091c3d64e,
        33'h092290653, 33'h0928e7657, 33'h092f4365c, 33'h0935a3660, 33'h093c07664, 33'h094270669,
        33'h0948dd66d, 33'h094f4f672, 33'h0955c5676, 33'h095c4067b, 33'h0962bf67f, 33'h096943684,
        33'h096fcb688, 33'h09765868d, 33'h097ce9691, 33'h09837f696, 33'h098a1969a, 33'h0990b869f,
        33'h09975c6a4, 33'h099e046a8, 33'h09a4b16ad, 33'h09ab636b2, 33'h09b2196b6, 33'h09b8d46bb,
        33'h09bf936bf, 33'h09c6576c4, 33'h09cd206c9, 33'h09d3ee6ce, 33'h09dac06d2, 33'h09e1976d7,
        33'h09e8736dc, 33'h09ef536e0, 33'h09f6386e5, 33'h09fd236eb, 33'h0a04116ee, 33'h0a0b056f4,
        33'h0a11fe6f9, 33'h0a18fb6fd, 33'h0a1ffd702, 33'h0a2704707, 33'h0a2e1070c, 33'h0a3521711,
        33'h0a3c37716, 33'h0a435171a, 33'h0a4a71720, 33'h0a5195724, 33'h0a58bf72a, 33'h0a5fed72e,
        33'h0a6721734, 33'h0a6e59738, 33'h0a759773e, 33'h0a7cd9742, 33'h0a8421748, 33'h0a8b6d74c,
        33'h0a92bf752, 33'h0a9a16757, 33'h0aa17175b, 33'h0aa8d2761, 33'h0ab038766, 33'h0ab7a476c,
        33'h0abf14770, 33'h0ac689775, 33'h0ace0477b, 33'h0ad584780, 33'h0add09785, 33'h0ae49378a,
        33'h0aec23790, 33'h0af3b8795, 33'h0afb5279a, 33'h0b02f179f, 33'h0b0a957a4, 33'h0b123f7aa,
        33'h0b19ef7b0, 33'h0b21a37b4, 33'h0b295d7ba, 33'h0b311c7bf, 33'h0b38e17c5, 33'h0b40ab7ca,
        33'h0b487a7cf, 33'h0b504f7d5, 33'h0b58297da, 33'h0b60097e0, 33'h0b67ee7e5, 33'h0b6fd97eb,
        33'h0b77c97f0, 33'h0b7fbf7f6, 33'h0b87ba7fb, 33'h0b8fbb801, 33'h0b97c1806, 33'h0b9fcd80c,
        33'h0ba7df812, 33'h0baff6817, 33'h0bb81281c, 33'h0bc035823, 33'h0bc85d828, 33'h0bd08a82d,
        33'h0bd8be834, 33'h0be0f7839, 33'h0be93583e, 33'h0bf17a845, 33'h0bf9c484a, 33'h0c0214850,
        33'h0c0a69855, 33'h0c12c585c, 33'h0c1b26861, 33'h0c238d867, 33'h0c2bfa86d, 33'h0c346d873,
        33'h0c3ce5878, 33'h0c456487f, 33'h0c4de8884, 33'h0c567388b, 33'h0c5f03890, 33'h0c6799896,
        33'h0c703589c, 33'h0c78d78a2, 33'h0c817f8a8, 33'h0c8a2e8af, 33'h0c92e28b4, 33'h0c9b9c8ba,
        33'h0ca45c8c0, 33'h0cad228c6, 33'h0cb5ef8cd, 33'h0cbec18d2, 33'h0cc79a8d9, 33'h0cd0798df,
        33'h0cd95e8e5, 33'h0ce2498eb, 33'h0ceb3a8f1, 33'h0cf4328f8, 33'h0cfd2f8fd, 33'h0d0633904,
        33'h0d0f3d90a, 33'h0d184e911, 33'h0d2165917, 33'h0d2a8291d, 33'h0d33a5923, 33'h0d3ccf92a,
        33'h0d45ff930, 33'h0d4f36937, 33'h0d587393d, 33'h0d61b6943, 33'h0d6b0094a, 33'h0d7450950,
        33'h0d7da6956, 33'h0d870495e, 33'h0d9067963, 33'h0d99d196a, 33'h0da342971, 33'h0dacb9977,
        33'h0db63797e, 33'h0dbfbb984, 33'h0dc94698b, 33'h0dd2d8992, 33'h0ddc70998, 33'h0de60f99f,
        33'h0defb59a6, 33'h0df9619ac, 33'h0e03149b3, 33'h0e0cce9ba, 33'h0e168e9c0, 33'h0e20569c8,
        33'h0e2a249ce, 33'h0e33f99d5, 33'h0e3dd49db, 33'h0e47b79e3, 33'h0e51a09e9, 33'h0e5b909f0,
        33'h0e65889f8, 33'h0e6f869fe, 33'h0e798ba05, 33'h0e8397a0c, 33'h0e8daaa13, 33'h0e97c4a1a,
        33'h0ea1e4a20, 33'h0eac0ca28, 33'h0eb63ba2f, 33'h0ec072a37, 33'h0ecaafa3d, 33'h0ed4f3a44,
        33'h0edf3ea4b, 33'h0ee991a53, 33'h0ef3eba5a, 33'h0efe4ca61, 33'h0f08b4a68, 33'h0f1323a6f,
        33'h0f1d9aa77, 33'h0f2817a7d, 33'h0f329da86, 33'h0f3d29a8c, 33'h0f47bda94, 33'h0f5258a9b,
        33'h0f5cfaaa2, 33'h0f67a4aaa, 33'h0f7255ab1, 33'h0f7d0eab9, 33'h0f87ceac0, 33'h0f9296ac8,
        33'h0f9d65acf, 33'h0fa83bad6, 33'h0fb319ade, 33'h0fbdffae6, 33'h0fc8ecaed, 33'h0fd3e1af5,
        33'h0fdeddafc, 33'h0fe9e1b04, 33'h0ff4edb0c, 33'h100000b13
    };

    localparam [LOG_N*LOG_WORD-1:0] LOG_TABLE =
        (LOG_BITS == 1) ? (LOG_N * LOG_WORD)'(LOG_1) :
        (LOG_BITS == 2) ? (LOG_N * LOG_WORD)'(LOG_2) :
        (LOG_BITS == 3) ? (LOG_N * LOG_WORD)'(LOG_3) :
        (LOG_BITS == 4) ? (LOG_N * LOG_WORD)'(LOG_4) :
        (LOG_BITS == 5) ? (LOG_N * LOG_WORD)'(LOG_5) :
        {LOG_N * LOG_WORD{1'b0}};

    localparam [EXP_N*EXP_WORD-1:0] EXP_TABLE =
        (EXP_BITS == 1) ? (EXP_N * EXP_WORD)'(EXP_1) :
        (EXP_BITS == 2) ? (EXP_N * EXP_WORD)'(EXP_2) :
        (EXP_BITS == 3) ? (EXP_N * EXP_WORD)'(EXP_3) :
        (EXP_BITS == 4) ? (EXP_N * EXP_WORD)'(EXP_4) :
        (EXP_BITS == 5) ? (EXP_N * EXP_WORD)'(EXP_5) :
        (EXP_BITS == 6) ? (EXP_N * EXP_WORD)'(EXP_6) :
        (EXP_BITS == 7) ? (EXP_N * EXP_WORD)'(EXP_7) :
        (EXP_BITS == 8) ? (EXP_N * EXP_WORD)'(EXP_8) :
        {EXP_N * EXP_WORD{1'b0}};
    /* verilator lint_on UNUSEDPARAM */

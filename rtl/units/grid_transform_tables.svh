    // Printed from datapath/numbers/log2.cpp: log2(1 + u) over an octave in pieces.
    /* verilator lint_off UNUSEDPARAM */

    localparam [27:0] LINEAR_1 = {
        14'h2635, 14'h014a
    };

    localparam [67:0] LINEAR_2 = {
        17'h19e63, 17'h12d71, 17'h0a786, 17'h002a5
    };

    localparam [159:0] LINEAR_3 = {
        20'he84bf, 20'hceccc, 20'hb38da, 20'h95eed, 20'h75d01, 20'h52b19,
        20'h2bd37, 20'h0075b
    };

    localparam [367:0] LINEAR_4 = {
        23'h7a2977, 23'h741984, 23'h6dd591, 23'h675d9e, 23'h60a5ae, 23'h59adbe,
        23'h5271cf, 23'h4ae5e3, 23'h4309f7, 23'h3ad60d, 23'h324225, 23'h293e41,
        23'h1fc65e, 23'h15ca7f, 23'h0b3ea3, 23'h000ecc
    };

    localparam [831:0] LINEAR_5 = {
        26'h3e8c2e9, 26'h3d122f4, 26'h3b91b01, 26'h3a0b30d, 26'h387db1b, 26'h36e9b28,
        26'h354eb36, 26'h33ac345, 26'h3202b53, 26'h3050b64, 26'h2e97373, 26'h2cd4b85,
        26'h2b09b96, 26'h2935ba8, 26'h27583bb, 26'h2570bcf, 26'h237f3e3, 26'h2182bf9,
        26'h1f7bc0e, 26'h1d68427, 26'h1b48c3f, 26'h191cc58, 26'h16e3473, 26'h149bc8f,
        26'h12454ad, 26'h0fdf4cc, 26'h0d694ec, 26'h0ae1510, 26'h0847d33, 26'h059ad5a,
        26'h02d8d84, 26'h0001dae
    };

    localparam [1855:0] LINEAR_6 = {
        29'h1fa365cb, 29'h1f45f5d7, 29'h1ee7c5e3, 29'h1e88d5ef, 29'h1e2925fb, 29'h1dc8a608,
        29'h1d676614, 29'h1d055621, 29'h1ca2662f, 29'h1c3eb63b, 29'h1bda164a, 29'h1b74a657,
        29'h1b0e5665, 29'h1aa71674, 29'h1a3ef682, 29'h19d5f690, 29'h196bf6a0, 29'h1900f6b0,
        29'h189506bf, 29'h182826ce, 29'h17ba36df, 29'h174b36f0, 29'h16db3700, 29'h166a1712,
        29'h15f7e723, 29'h15849735, 29'h15102747, 29'h149a9759, 29'h1423c76d, 29'h13abc780,
        29'h13329793, 29'h12b817a8, 29'h123c57bc, 29'h11bf47d1, 29'h1140e7e6, 29'h10c127fc,
        29'h103ff813, 29'h0fbd6829, 29'h0f395841, 29'h0eb3c859, 29'h0e2cb871, 29'h0da4188a,
        29'h0d19d8a4, 29'h0c8e08bd, 29'h0c0078d9, 29'h0b7138f4, 29'h0ae03910, 29'h0a4d692d,
        29'h09b8b94b, 29'h09222969, 29'h0889a988, 29'h07ef29a8, 29'h0752a9c8, 29'h06b409ea,
        29'h06133a0d, 29'h05703a30, 29'h04caea55, 29'h04234a7a, 29'h03793aa1, 29'h02ccaac9,
        29'h021d9af1, 29'h016beb1b, 29'h00b77b47, 29'h00003b74
    };

    localparam [4095:0] LINEAR_7 = {
        32'hfe8e0b91, 32'hfd1a8b9c, 32'hfba58ba8, 32'hfa2f2bb3, 32'hf8b72bc0, 32'hf73dcbcb,
        32'hf5c2cbd8, 32'hf4464be4, 32'hf2c84bf0, 32'hf148cbfc, 32'hefc7ac09, 32'hee44ec16,
        32'hecc0ac22, 32'heb3acc2f, 32'he9b34c3c, 32'he82a2c49, 32'he69f4c57, 32'he512ec63,
        32'he384cc71, 32'he1f50c7e, 32'he0638c8c, 32'hded06c99, 32'hdd3b6ca8, 32'hdba4ccb5,
        32'hda0c6cc3, 32'hd8722cd2, 32'hd6d62ce0, 32'hd5386cee, 32'hd398ccfd, 32'hd1f76d0b,
        32'hd0542d1a, 32'hceaeed2a, 32'hcd07ed38, 32'hcb5f0d47, 32'hc9b42d57, 32'hc8074d67,
        32'hc658ad75, 32'hc4a7ed86, 32'hc2f52d96, 32'hc1406da6, 32'hbf89cdb5, 32'hbdd0edc7,
        32'hbc160dd7, 32'hba592de7, 32'hb89a2df8, 32'hb6d8ee0a, 32'hb515ae1a, 32'hb3502e2c,
        32'hb1888e3d, 32'hafbeae4f, 32'hadf28e61, 32'hac244e72, 32'haa53ae85, 32'ha880ce97,
        32'ha6ab8eaa, 32'ha4d3eebd, 32'ha2fa0ecf, 32'ha11daee3, 32'h9f3f0ef5, 32'h9d5dcf0a,
        32'h9b7a2f1d, 32'h99940f31, 32'h97ab6f45, 32'h95c04f59, 32'h93d28f6e, 32'h91e24f82,
        32'h8fef4f98, 32'h8df9cfac, 32'h8c018fc2, 32'h8a068fd8, 32'h8808cfee, 32'h86087003,
        32'h8405301a, 32'h81ff1031, 32'h7ff63047, 32'h7dea505f, 32'h7bdb9076, 32'h79c9f08d,
        32'h77b530a6, 32'h759d90bd, 32'h7382d0d6, 32'h716510ee, 32'h6f441108, 32'h6d1ff121,
        32'h6af8b13a, 32'h68ce1155, 32'h66a0516e, 32'h646f3189, 32'h623ab1a4, 32'h6002d1bf,
        32'h5dc791da, 32'h5b88d1f6, 32'h59469212, 32'h5700b22f, 32'h54b7524b, 32'h526a3269,
        32'h50197286, 32'h4dc4d2a5, 32'h4b6c92c2, 32'h491072e1, 32'h46b07300, 32'h444c7320,
        32'h41e47340, 32'h3f787360, 32'h3d087380, 32'h3a9433a2, 32'h381bd3c3, 32'h359f13e6,
        32'h331e1408, 32'h3098b42b, 32'h2e0ed44f, 32'h2b809472, 32'h28edb497, 32'h265634bc,
        32'h23b9f4e2, 32'h21191507, 32'h1e73552e, 32'h1bc8b555, 32'h1919157d, 32'h166455a6,
        32'h13aa95ce, 32'h10eb95f8, 32'h0e277621, 32'h0b5dd64d, 32'h088ed678, 32'h05ba56a4,
        32'h02e036d1, 32'h000076fe
    };

    localparam [8447:0] LINEAR_8 = {
        33'h1fe8e6b8d, 33'h1fd1c0b93, 33'h1fba8cb9a, 33'h1fa34eb9f, 33'h1f8c06ba4, 33'h1f74b0bab,
        33'h1f5d4ebb1, 33'h1f45e2bb6, 33'h1f2e68bbd, 33'h1f16e4bc2, 33'h1eff52bc9, 33'h1ee7b6bce,
        33'h1ed00cbd5, 33'h1eb856bdb, 33'h1ea096be0, 33'h1e88c8be7, 33'h1e70eebed, 33'h1e5908bf3,
        33'h1e4114bfa, 33'h1e2914c00, 33'h1e110ac05, 33'h1df8f0c0d, 33'h1de0ccc12, 33'h1dc89ac19,
        33'h1db05cc1f, 33'h1d9812c25, 33'h1d7fbac2c, 33'h1d6754c33, 33'h1d4ee4c38, 33'h1d3664c40,
        33'h1d1dd8c46, 33'h1d0540c4c, 33'h1cec9ac53, 33'h1cd3e8c59, 33'h1cbb28c60, 33'h1ca25ac67,
        33'h1c897ec6e, 33'h1c7096c74, 33'h1c57a0c7b, 33'h1c3e9ec81, 33'h1c258cc89, 33'h1c0c6ec8f,
        33'h1bf342c96, 33'h1bda08c9d, 33'h1bc0c0ca4, 33'h1ba76acab, 33'h1b8e08cb1, 33'h1b7496cb9,
        33'h1b5b16cc0, 33'h1b4188cc7, 33'h1b27eccce, 33'h1b0e42cd5, 33'h1af48acdc, 33'h1adac2ce4,
        33'h1ac0eecea, 33'h1aa70acf2, 33'h1a8d18cf9, 33'h1a7316d01, 33'h1a5908d07, 33'h1a3ee8d10,
        33'h1a24bcd16, 33'h1a0a80d1e, 33'h19f034d26, 33'h19d5dad2d, 33'h19bb72d34, 33'h19a0fad3c,
        33'h198672d44, 33'h196bdcd4b, 33'h195136d53, 33'h193680d5b, 33'h191bbcd62, 33'h1900e8d6a,
        33'h18e602d73, 33'h18cb10d79, 33'h18b00cd82, 33'h1894f8d8a, 33'h1879d4d92, 33'h185ea2d99,
        33'h18435eda2, 33'h18280adaa, 33'h180ca8db1, 33'h17f134dba, 33'h17d5aedc3, 33'h17ba1adca,
        33'h179e74dd3, 33'h1782beddb, 33'h1766f8de3, 33'h174b20dec, 33'h172f38df4, 33'h171340dfc,
        33'h16f736e05, 33'h16db1ae0e, 33'h16beeee16, 33'h16a2b0e1f, 33'h168662e27, 33'h166a02e30,
        33'h164d90e39, 33'h16310ce42, 33'h161478e4a, 33'h15f7d2e53, 33'h15db18e5d, 33'h15be4ee65,
        33'h15a172e6e, 33'h158484e77, 33'h156782e81, 33'h154a70e89, 33'h152d4ae93, 33'h151012e9c,
        33'h14f2c8ea5, 33'h14d56ceae, 33'h14b7fceb8, 33'h149a7aec1, 33'h147ce4ecb, 33'h145f3ced4,
        33'h144180ede, 33'h1423b2ee7, 33'h1405d0ef1, 33'h13e7daefb, 33'h13c9d2f04, 33'h13abb6f0e,
        33'h138d86f18, 33'h136f42f22, 33'h1350eaf2c, 33'h13327ef36, 33'h1313fef40, 33'h12f56af4a,
        33'h12d6c2f54, 33'h12b804f5f, 33'h129934f68, 33'h127a4ef73, 33'h125b52f7e, 33'h123c44f87,
        33'h121d1ef93, 33'h11fde6f9c, 33'h11de96fa8, 33'h11bf32fb2, 33'h119fbafbc, 33'h11802afc8,
        33'h116086fd2, 33'h1140ccfdd, 33'h1120fcfe8, 33'h110116ff3, 33'h10e118fff, 33'h10c107009,
        33'h10a0df014, 33'h10809f020, 33'h10604902b, 33'h103fdd036, 33'h101f59042, 33'h0ffebf04d,
        33'h0fde0d059, 33'h0fbd45064, 33'h0f9c65070, 33'h0f7b6d07c, 33'h0f5a5f087, 33'h0f3937094,
        33'h0f17f909f, 33'h0ef6a30ab, 33'h0ed5330b8, 33'h0eb3ad0c3, 33'h0e920d0d0, 33'h0e70550dc,
        33'h0e4e850e8, 33'h0e2c9b0f5, 33'h0e0a97102, 33'h0de87d10d, 33'h0dc64711b, 33'h0da3f9127,
        33'h0d8191134, 33'h0d5f0f141, 33'h0d3c7314e, 33'h0d19bd15b, 33'h0cf6ed168, 33'h0cd403175,
        33'h0cb0ff182, 33'h0c8ddf190, 33'h0c6aa519d, 33'h0c47511aa, 33'h0c23e11b8, 33'h0c00551c6,
        33'h0bdcaf1d3, 33'h0bb8ed1e1, 33'h0b950d1f0, 33'h0b71131fd, 33'h0b4cfd20b, 33'h0b28cb219,
        33'h0b047b228, 33'h0ae00f236, 33'h0abb87244, 33'h0a96e1253, 33'h0a721f261, 33'h0a4d3f270,
        33'h0a284127f, 33'h0a032528e, 33'h09dded29c, 33'h09b8952ac, 33'h09931f2bb, 33'h096d8b2ca,
        33'h0947d92d9, 33'h0922072e9, 33'h08fc152f9, 33'h08d605308, 33'h08afd7317, 33'h088987328,
        33'h086317338, 33'h083c89347, 33'h0815d9358, 33'h07ef09368, 33'h07c817379, 33'h07a107388,
        33'h0779d339a, 33'h07527f3aa, 33'h072b093bb, 33'h0703713cc, 33'h06dbb73dd, 33'h06b3db3ee,
        33'h068bdb400, 33'h0663bb410, 33'h063b75423, 33'h06130f433, 33'h05ea83446, 33'h05c1d3458,
        33'h059901469, 33'h05700947c, 33'h0546ef48d, 33'h051dad4a1, 33'h04f4494b2, 33'h04cabd4c6,
        33'h04a10d4d8, 33'h0477374eb, 33'h044d3b4fe, 33'h042319511, 33'h03f8d1524, 33'h03ce61538,
        33'h03a3cb54b, 33'h03790b560, 33'h034e25573, 33'h032317587, 33'h02f7e159b, 33'h02cc835af,
        33'h02a0fb5c4, 33'h0275495d9, 33'h02496f5ed, 33'h021d6b602, 33'h01f13d617, 33'h01c4e362d,
        33'h01985f642, 33'h016bb1657, 33'h013ed766d, 33'h0111d1683, 33'h00e49f699, 33'h00b7416af,
        33'h0089b56c6, 33'h005bfd6dc, 33'h002e176f3, 33'h00000370a
    };

    localparam [61:0] QUADRATIC_1 = {
        31'h4ae6a47a, 31'h00095cf1
    };

    localparam [147:0] QUADRATIC_2 = {
        37'h19d63150d2, 37'h12b838f118, 37'h0a4d435989, 37'h0000526a4c
    };

    localparam [343:0] QUADRATIC_3 = {
        43'h741517d618a, 43'h6757997b1c1, 43'h59a81b5f206, 43'h4ae01d9025e, 43'h3acee022acb, 43'h29352333b59,
        43'h15c026ea419, 43'h00002b80520
    };

    localparam [783:0] QUADRATIC_4 = {
        49'h1e88c6bb9d2fb, 49'h1d0540c1c332d, 49'h1b7494c856365, 49'h19d5dacf5d3a4, 49'h18280ad6e83e8, 49'h166a00df05436,
        49'h149a78e7c448c, 49'h12b804f13a4ec, 49'h10c106fb7f558, 49'h0eb3ab06ae5d5, 49'h0c8ddf12e6664, 49'h0a4d3d2051708,
        49'h07ef072f1b7c6, 49'h0570073f808a3, 49'h02cc7f51c49a8, 49'h000001663fadc
    };

    localparam [1471:0] QUADRATIC_5 = {
        46'h3e8bc17440bc, 46'h3d118d7a34c3, 46'h3b91358058c8, 46'h3a0a8186b4ce, 46'h387d398d48d6, 46'h36e9299410de,
        46'h354e119b18e6, 46'h33abb5a25cee, 46'h3201cda9e8f6, 46'h305015b1b8ff, 46'h2e9641b9d508, 46'h2cd401c24113,
        46'h2b0905cafd1e, 46'h2934f1d41529, 46'h275769dd8935, 46'h257009e76141, 46'h237e65f1a54e, 46'h21820dfc595c,
        46'h1f7a8607896d, 46'h1d675613317f, 46'h1b47ee1f6990, 46'h191bbe2c31a2, 46'h16e222399db7, 46'h149a7a47a9ce,
        46'h12440a5671e5, 46'h0fde0e65fdfe, 46'h0d67b2765e19, 46'h0ae00e87a638, 46'h08462e99e259, 46'h0598fead327d,
        46'h02d75ec1a2a2, 46'h000002d75ecb
    };

    localparam [N*WORD-1:0] TABLE =
        (QUADRATIC == 0 && INDEX_BITS == 1) ? (N * WORD)'(LINEAR_1) :
        (QUADRATIC == 0 && INDEX_BITS == 2) ? (N * WORD)'(LINEAR_2) :
        (QUADRATIC == 0 && INDEX_BITS == 3) ? (N * WORD)'(LINEAR_3) :
        (QUADRATIC == 0 && INDEX_BITS == 4) ? (N * WORD)'(LINEAR_4) :
        (QUADRATIC == 0 && INDEX_BITS == 5) ? (N * WORD)'(LINEAR_5) :
        (QUADRATIC == 0 && INDEX_BITS == 6) ? (N * WORD)'(LINEAR_6) :
        (QUADRATIC == 0 && INDEX_BITS == 7) ? (N * WORD)'(LINEAR_7) :
        (QUADRATIC == 0 && INDEX_BITS == 8) ? (N * WORD)'(LINEAR_8) :
        (QUADRATIC != 0 && INDEX_BITS == 1) ? (N * WORD)'(QUADRATIC_1) :
        (QUADRATIC != 0 && INDEX_BITS == 2) ? (N * WORD)'(QUADRATIC_2) :
        (QUADRATIC != 0 && INDEX_BITS == 3) ? (N * WORD)'(QUADRATIC_3) :
        (QUADRATIC != 0 && INDEX_BITS == 4) ? (N * WORD)'(QUADRATIC_4) :
        (QUADRATIC != 0 && INDEX_BITS == 5) ? (N * WORD)'(QUADRATIC_5) :
        {N * WORD{1'b0}};
    /* verilator lint_on UNUSEDPARAM */

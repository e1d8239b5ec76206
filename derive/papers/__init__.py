"""The papers, by the names that the ledger gives them."""

PAPERS = {
    "song-lee-2001": "boresight.derive.papers.song_lee_2001",
    "kim-2018": "boresight.derive.papers.kim_2018",
    "kang-2025": "boresight.derive.papers.kang_2025",
}

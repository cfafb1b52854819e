// Colors for blocks of the language. A test holds the keywords against those of the parser.
hljs.registerLanguage("lmsl", () => ({
    keywords: {
        $pattern: /[a-z_]+/,
        keyword:
            "action activity after again always and arbiter behavior client contributor decide detractor done else " +
            "emergency entry event expect extends fail fault final flag goal import in interface is logical mode " +
            "network never not on or output place property provides requires robot rule runs scenario sense sensor " +
            "team variable world",
    },
    contains: [
        hljs.C_LINE_COMMENT_MODE,
        { className: "symbol", begin: /^\s*\d+:/ },
        { className: "number", begin: /(?<![\w.^])-?\d+(\.\d+)?(e-?\d+)?/ },
    ],
}));

for (const block of document.querySelectorAll('code[class*="language-msd"], code[class*="language-fsfn"]')) {
    block.className = "language-lmsl";
    hljs.highlightBlock(block);
}

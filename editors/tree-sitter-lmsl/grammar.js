/// <reference types="tree-sitter-cli/dsl" />
// The language for editors that read trees. What it means stands in the compiler's own grammar, `grammar/`; the words
// in quotes are those of its keywords, which a test demands.
//
// A keyword is one only where the grammar has a place for it; elsewhere it is a name.

/** @param {RuleOrLiteral} rule */
const list = (rule) => seq(rule, repeat(seq(',', rule)));

/** @param {RuleOrLiteral} item */
const block = (item) => seq('{', repeat(item), '}');

const LEVEL = { or: 1, and: 2, not: 3, compare: 4, add: 5, multiply: 6, negate: 7, call: 8 };

module.exports = grammar({
    name: 'lmsl',

    extras: ($) => [/[\s\uFEFF]/, $.comment, $.doc_comment],
    word: ($) => $.identifier,
    // `lag 0.15 s track 0.6 m`: whether a word is a unit shows behind it.
    conflicts: ($) => [[$.quantity]],
    supertypes: ($) => [$.declaration, $.expression],

    rules: {
        source_file: ($) => repeat($.declaration),

        // Of two comments as long as each other the first rule's is meant.
        doc_comment: () => /\/\/\/([^/\r\n][^\r\n]*)?/,
        comment: () => /\/\/[^\r\n]*/,

        declaration: ($) =>
            choice(
                $.import,
                $.variable,
                $.network,
                $.interface,
                $.robot,
                $.diagram,
                $.arbiter,
                $.team,
                $.world,
                $.scenario,
                $.property,
            ),

        import: ($) => seq('import', alias($.path, $.module_path)),

        // Names, numbers, units

        identifier: () => /[A-Za-z][A-Za-z0-9_]*|_[A-Za-z0-9_]+/,
        path: ($) => seq($.identifier, repeat(seq(token.immediate('.'), field('member', $._segment)))),
        _segment: ($) => alias(token.immediate(/[A-Za-z_][A-Za-z0-9_]*/), $.identifier),
        number: () => /-?\d+(\.\d+)?([eE][+-]?\d+)?/,
        quantity: ($) => seq($.number, optional($._any_unit)),
        range: ($) => seq($.quantity, '..', $.quantity),
        unit: ($) => seq($._unit_factor, repeat(seq(token.immediate(prec(1, /[*/]/)), $._unit_factor))),
        _unit_factor: ($) => seq(choice($.identifier, '%'), optional(token.immediate(/\^-?\d+/))),
        // The unit of a plain number is `1`, where one must be named.
        plain_unit: () => token(prec(1, /1(\/[A-Za-z][A-Za-z0-9_]*(\^-?\d+)?)?/)),
        _any_unit: ($) => choice($.unit, alias($.plain_unit, $.unit)),

        // Variables and networks

        variable: ($) =>
            seq(
                'variable',
                field('name', $.identifier),
                ':',
                $._any_unit,
                optional($.range_clause),
                optional($.fails_clause),
                $.terms,
            ),
        range_clause: ($) => seq('in', $.range),
        fails_clause: ($) => seq('fails', list($._fail_reading)),
        _fail_reading: ($) => choice($.quantity, 'any', 'absent', 'set', 'clear'),
        terms: ($) => block($.term),
        term: ($) => seq(field('name', $.identifier), '=', $._shape),

        _shape: ($) => seq($._shape_operand, repeat(seq(choice('and', 'or'), $._shape_operand))),
        _shape_operand: ($) =>
            seq(
                repeat(choice('not', 'very', 'somewhat')),
                choice($.shape_group, $.points, $.shape, alias($.identifier, $.term_name)),
            ),
        shape_group: ($) => seq('(', $._shape, ')'),
        points: ($) => seq('points', '(', list($.point), ')'),
        point: ($) => seq('(', $.quantity, ',', $.quantity, ')'),
        shape: ($) => seq(field('function', $.identifier), '(', optional(list($.quantity)), ')'),

        network: ($) =>
            seq('network', field('name', $.identifier), $.inputs, optional($.using), block($._network_item)),
        inputs: ($) => seq('(', optional(list($.input)), ')'),
        input: ($) => seq(field('name', $.identifier), ':', field('variable', $.identifier)),
        using: ($) => seq('using', '{', list($.setting), '}'),
        setting: ($) => seq(choice('and', 'or', $.identifier), repeat1(choice($.identifier, $.number))),
        _network_item: ($) => choice($.event, $.output, $.output_rule),

        event: ($) => seq('event', field('name', $.identifier), repeat($._event_option), block($.side)),
        _event_option: ($) =>
            choice(seq('over', '(', list($.identifier), ')'), seq(choice('hysteresis', 'hold', 'confirm'), $.quantity)),
        side: ($) => seq(choice('contributor', 'detractor'), repeat1(choice($.row, $.rule))),
        rule: ($) => seq('rule', $.expression),
        row: ($) => seq('(', list($._cell), ')'),
        _cell: ($) =>
            choice(alias($.identifier, $.term_name), $.term_set, alias('-', $.wildcard), alias('_', $.wildcard)),
        term_set: ($) => seq('{', list(alias($.identifier, $.term_name)), '}'),

        output: ($) =>
            seq(
                'output',
                field('name', $.identifier),
                ':',
                $._any_unit,
                optional($.range_clause),
                optional(seq('default', choice('hold', $.quantity))),
                choice($.terms, seq('=', 'takagi_sugeno')),
            ),
        output_rule: ($) =>
            seq(
                'rule',
                $.expression,
                '=>',
                $.consequent,
                repeat(seq('and', $.consequent)),
                optional(seq('weight', $.number)),
            ),
        consequent: ($) =>
            seq(
                field('output', $.identifier),
                choice(seq('is', alias($.identifier, $.term_name)), seq('=', $._arithmetic)),
            ),

        // Interfaces and robots

        interface: ($) =>
            seq(
                'interface',
                field('name', $.identifier),
                optional(seq('extends', alias($.identifier, $.type_name))),
                block($._robot_item),
            ),
        robot: ($) =>
            seq(
                'robot',
                field('name', $.identifier),
                optional(seq('provides', list(alias($.identifier, $.type_name)))),
                optional(seq('runs', alias($.identifier, $.type_name))),
                block($._robot_item),
            ),
        _robot_item: ($) => choice($.body, $.sensor, $.sense, $.logical, $.action),
        body: ($) => seq('body', field('name', $.identifier), block($.parameter_value)),
        parameter_value: ($) => seq(field('name', $.identifier), choice($.quantity, $.tuple)),
        tuple: ($) => seq('(', list($.quantity), ')'),
        sensor: ($) =>
            seq(
                optional('optional'),
                'sensor',
                field('name', $.identifier),
                optional(seq('[', $.number, ']')),
                ':',
                choice('contact', seq($._any_unit, optional($.range_clause))),
                repeat($._sensor_clause),
            ),
        _sensor_clause: ($) =>
            choice($.fails_clause, seq('=', $.path), seq(choice('noise', 'accuracy', 'period', 'beam'), $.quantity)),
        logical: ($) =>
            seq(
                'logical',
                field('name', $.identifier),
                '=',
                $.expression,
                optional(seq('within', $.quantity)),
            ),
        action: ($) =>
            prec.right(
                seq(
                    optional('optional'),
                    'action',
                    field('name', $.identifier),
                    $.parameters,
                    optional(seq('->', 'done')),
                    optional(seq('=', $.call)),
                ),
            ),
        parameters: ($) => seq('(', optional(list($.parameter)), ')'),
        parameter: ($) => seq(field('name', $.identifier), ':', $._any_unit),

        // Mode switching diagrams

        diagram: ($) =>
            seq(
                choice('behavior', 'activity', 'goal'),
                field('name', $.identifier),
                repeat(seq(choice('on', 'extends'), alias($.identifier, $.type_name))),
                block($._diagram_item),
            ),
        _diagram_item: ($) => choice($.sense, $.entry, $.flag, $.mode),
        sense: ($) =>
            seq('sense', optional(seq(field('alias', $.identifier), '=')), field('network', $.identifier), $.arguments),
        entry: ($) => seq('entry', $._mode_name),
        flag: ($) => seq('flag', field('name', $.identifier), '=', $.expression),
        mode: ($) =>
            seq(
                optional('final'),
                'mode',
                field('name', $.identifier),
                repeat(
                    choice(
                        seq('=', alias($.identifier, $.type_name), optional('resume')),
                        seq('requires', list($.identifier), optional(seq('else', $._mode_name))),
                    ),
                ),
                optional($.mode_block),
            ),
        mode_block: ($) => block(choice($.transition, $.call, $.on_enter, $.on_exit, $.decide)),
        _mode_name: ($) => alias($.identifier, $.mode_name),
        transition: ($) =>
            seq(alias($.number, $.priority), ':', $.expression, '->', field('target', choice('again', $._mode_name))),
        on_enter: ($) => seq('on', 'enter', block($.call)),
        on_exit: ($) => seq('on', 'exit', block($.call)),
        decide: ($) => seq('decide', '(', list($.expression), ')', block($.decide_row)),
        decide_row: ($) => seq($.row, '=>', choice('nothing', $.expression)),

        // Arbiters and teams

        arbiter: ($) =>
            seq(
                'arbiter',
                field('name', $.identifier),
                optional(seq('on', alias($.identifier, $.type_name))),
                block(choice($.emergency, $.client, $.ties)),
            ),
        emergency: ($) => seq('emergency', $.expression, '->', $.call),
        client: ($) =>
            seq(
                'client',
                field('name', $.identifier),
                '=',
                alias($.identifier, $.type_name),
                'priority',
                $._client_priority,
                repeat(seq('else', $._client_priority)),
            ),
        _client_priority: ($) => seq(alias($.number, $.priority), optional(seq('when', $.expression))),
        ties: ($) => seq('ties', $.identifier),
        team: ($) => seq('team', field('name', $.identifier), block(choice($.member, $.link))),
        member: ($) =>
            seq(
                'robot',
                field('name', $.identifier),
                '=',
                alias($.identifier, $.type_name),
                'runs',
                alias($.identifier, $.type_name),
            ),
        link: ($) => seq($.path, '=', $.expression),

        // Worlds, scenarios, properties

        world: ($) =>
            seq('world', field('name', $.identifier), block(choice($.wall, $.door, $.box, $.goal))),
        wall: ($) => seq('wall', $.point, repeat1(seq('->', $.point))),
        door: ($) => seq('door', 'at', $.point, 'width', $.quantity, optional($._heading), optional('open')),
        _heading: ($) => seq('heading', $.quantity),
        goal: ($) => seq('goal', $.point),
        box: ($) =>
            seq(
                'box',
                optional(field('name', choice($.identifier, alias('mass', $.identifier)))),
                'mass',
                $.quantity,
                'size',
                $.point,
                'at',
                $._place_at,
            ),
        _place_at: ($) => choice(seq($.point, optional($._heading)), seq($.quantity, 'ahead')),

        scenario: ($) =>
            seq(
                'scenario',
                field('name', $.identifier),
                repeat(seq(choice('runs', 'on', 'in', 'extends'), alias($.identifier, $.type_name))),
                block(choice($.setting_of_run, $.place, $.fault, $.fail, $.expectation)),
            ),
        setting_of_run: ($) => choice(seq(choice('duration', 'tick'), $.quantity), seq('seed', $.number)),
        place: ($) => seq('place', choice($.place_robot, $.box)),
        place_robot: ($) => seq('robot', optional(field('name', $.identifier)), 'at', $._place_at),
        fault: ($) => seq('fault', $.sensor_reference, '=', $._fail_reading, optional($._from), optional($._to)),
        fail: ($) => seq('fail', $.sensor_reference, optional($._from), optional($._to)),
        sensor_reference: ($) => seq($.path, optional($.indices)),
        _from: ($) => seq('from', $.quantity),
        _to: ($) => seq('to', $.quantity),

        expectation: ($) =>
            seq(
                'expect',
                choice(
                    seq('modes', list($._mode_name)),
                    seq(
                        choice('never', 'always'),
                        $.expression,
                        optional(choice(seq(choice('before', 'after'), $.quantity), $._within)),
                    ),
                    seq($._mode_name, '->', $._mode_name, optional($._within)),
                    seq($.expression, optional($._within)),
                ),
            ),
        _within: ($) => seq('within', $.range),

        property: ($) =>
            seq(
                'property',
                field('name', $.identifier),
                optional(seq('of', alias($.identifier, $.type_name))),
                ':',
                choice(
                    seq(choice('never', 'always'), $.expression),
                    seq($.expression, 'leads', 'to', $.expression, optional(seq('within', $.quantity))),
                ),
            ),

        // Expressions

        expression: ($) => choice($._arithmetic, $.comparison, $.is_test, $.not, $.conjunction, $.disjunction),
        disjunction: ($) => prec.left(LEVEL.or, seq($.expression, 'or', $.expression)),
        conjunction: ($) => prec.left(LEVEL.and, seq($.expression, 'and', $.expression)),
        not: ($) => prec(LEVEL.not, seq('not', $.expression)),
        comparison: ($) =>
            prec.left(LEVEL.compare, seq($._arithmetic, choice('<', '<=', '>', '>=', '==', '!='), $._arithmetic)),
        is_test: ($) =>
            prec.left(
                LEVEL.compare,
                seq($._arithmetic, 'is', choice(seq('any', 'of', $.term_set), alias($.identifier, $.term_name))),
            ),

        _arithmetic: ($) => choice($.sum, $.product, $.negation, $._operand),
        sum: ($) => prec.left(LEVEL.add, seq($._arithmetic, choice('+', '-'), $._arithmetic)),
        product: ($) => prec.left(LEVEL.multiply, seq($._arithmetic, choice('*', '/'), $._arithmetic)),
        negation: ($) => prec(LEVEL.negate, seq('-', $._arithmetic)),
        _operand: ($) => choice($.group, $.after, $.done, $.quantity, $.path, $.call, $.indexed),
        group: ($) => seq('(', $.expression, ')'),
        after: ($) => seq('after', $.quantity),
        done: () => 'done',
        call: ($) => prec(LEVEL.call, seq(field('function', alias($.path, $.function_path)), $.arguments)),
        indexed: ($) => seq($.path, $.indices),
        arguments: ($) => seq('(', optional(list($.argument)), ')'),
        argument: ($) => seq(optional(seq(field('name', $.identifier), ':')), $.expression),
        indices: ($) => seq('[', list($.index_range), ']'),
        index_range: ($) => seq($.number, optional(seq('..', $.number))),
    },
});

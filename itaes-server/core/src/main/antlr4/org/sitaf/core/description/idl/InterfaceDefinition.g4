/*
 * Interfaces in OMG IDL (4.2, building blocks for data types and interfaces, and the older spellings
 * of CORBA). What describes no interface is recognised and passed over: value types, components.
 * Rules have no left recursion and lists are flat, so that the depth of a parse tree is bounded by
 * the nesting of brackets, which is checked before.
 */
grammar InterfaceDefinition;

specification: definition* EOF;

definition
    : annotation* (module | interfaceDeclaration | interfaceForward | typeDeclaration | constant | exception | other) ';'
    ;

module: 'module' name '{' definition* '}';

interfaceForward: ('abstract' | 'local')? 'interface' name;
interfaceDeclaration
    : ('abstract' | 'local')? 'interface' name (':' scopedName (',' scopedName)*)? '{' export* '}'
    ;

export
    : annotation* (operation | attribute | typeDeclaration | constant | exception) ';'
    ;

operation
    : ONEWAY? (VOID | typeSpec) name '(' (parameter (',' parameter)*)? ')' raises? context?
    ;
parameter: annotation* (IN | OUT | INOUT)? typeSpec name;
raises: 'raises' '(' scopedName (',' scopedName)* ')';
context: 'context' '(' STRING (',' STRING)* ')';

attribute
    : READONLY? 'attribute' typeSpec name (',' name)* (raises | ('getraises' | 'setraises') '(' scopedName (',' scopedName)* ')')*
    ;

typeDeclaration: struct | structForward | union | unionForward | enumeration | bits | typedef | 'native' name;

structForward: 'struct' name;
struct: 'struct' name (':' scopedName)? '{' member* '}';
exception: 'exception' name '{' member* '}';
member: annotation* declaredType declarator (',' declarator)* ';';

unionForward: 'union' name;
union: 'union' name 'switch' '(' annotation* typeSpec ')' '{' unionCase+ '}';
unionCase: (('case' expression | 'default') ':')+ annotation* declaredType declarator ';';

enumeration: 'enum' name '{' enumerator (',' enumerator)* ','? '}';
enumerator: annotation* name;

bits: ('bitset' | 'bitmask') name (':' scopedName)? block;

typedef: 'typedef' declaredType declarator (',' declarator)*;
declarator: name dimension*;
dimension: '[' expression ']';

declaredType: struct | union | enumeration | typeSpec;

typeSpec: baseType | sequence | stringType | fixedType | map | scopedName;
baseType
    : 'float'
    | 'long'? 'double'
    | 'unsigned'? ('short' | 'long' 'long'?)
    | 'char' | 'wchar' | 'boolean' | 'octet' | 'any' | 'Object' | 'ValueBase'
    | 'int8' | 'int16' | 'int32' | 'int64' | 'uint8' | 'uint16' | 'uint32' | 'uint64'
    ;
sequence: 'sequence' '<' annotation* typeSpec (',' expression)? '>';
stringType: ('string' | 'wstring') ('<' expression '>')?;
fixedType: 'fixed' ('<' expression ',' expression '>')?;
map: 'map' '<' typeSpec ',' typeSpec (',' expression)? '>';

constant: 'const' typeSpec name '=' expression;

expression: xorExpression ('|' xorExpression)*;
xorExpression: andExpression ('^' andExpression)*;
andExpression: shiftExpression ('&' shiftExpression)*;
shiftExpression: sum (('<' '<' | '>' '>') sum)*;
sum: product (('+' | '-') product)*;
product: unary (('*' | '/' | '%') unary)*;
unary: ('-' | '+' | '~')* primary;
primary: INTEGER | REAL | CHARACTER | STRING+ | 'TRUE' | 'FALSE' | scopedName | '(' expression ')';

other
    : ('abstract' | 'custom')? ('valuetype' | 'eventtype' | 'component' | 'home' | 'porttype' | 'connector' | 'typeid' | 'typeprefix' | 'import')
      ~('{' | '}' | ';')* block?
    ;
block: '{' (block | ~('{' | '}'))* '}';

annotation: '@' (scopedName | 'default') ('(' (argument (',' argument)*)? ')')?;
argument: (name '=')? expression;

scopedName: '::'? name ('::' name)*;
// Words that only newer or larger profiles of IDL reserve; older files use them as names.
name
    : IDENTIFIER
    | 'map' | 'fixed' | 'bitset' | 'bitmask' | 'int8' | 'uint8' | 'int16' | 'uint16' | 'int32' | 'uint32' | 'int64' | 'uint64'
    | 'component' | 'home' | 'porttype' | 'connector' | 'eventtype' | 'import' | 'typeid' | 'typeprefix' | 'local' | 'native'
    | 'getraises' | 'setraises' | 'custom'
    ;

ONEWAY: 'oneway';
VOID: 'void';
READONLY: 'readonly';
IN: 'in';
OUT: 'out';
INOUT: 'inout';
IDENTIFIER: [A-Za-z_] [A-Za-z0-9_]*;
INTEGER: '0' [xX] [0-9a-fA-F]+ | [0-9]+;
REAL: ([0-9]+ '.' [0-9]* | '.' [0-9]+) ([eE] [+-]? [0-9]+)? [fFdD]? | [0-9]+ [eE] [+-]? [0-9]+ [fFdD]? | [0-9]+ ('.' [0-9]*)? [dD];
CHARACTER: 'L'? '\'' (~['\\\r\n] | '\\' ~[\r\n] [0-7xa-fA-FuU]*) '\'';
STRING: 'L'? '"' (~["\\\r\n] | '\\' ~[\r\n])* '"';

BLOCK_COMMENT: '/*' .*? '*/' -> skip;
LINE_COMMENT: '//' ~[\r\n]* -> skip;
SPACE: [ \t\r\n\f\u000B\uFEFF]+ -> skip;
UNEXPECTED: .;

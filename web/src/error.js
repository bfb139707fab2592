/** The error that a rejected call throws. The world is unchanged. */
export class CairnError extends Error {
    /**
     * @param {string} code the kind of error, one of `CairnErrorCode` in index.d.ts
     * @param {string} message a description of the error
     * @param {string} field the invalid argument or member, such as `BodyDef.mass`; may be empty
     * @param {string} value its value; may be empty
     */
    constructor(code, message, field = '', value = '') {
        super(message);
        this.name = 'CairnError';
        this.code = code;
        this.field = field;
        this.value = value;
    }
}

// Error codes in the order of the numbers of cairn_result.
export const CODES = [
    'ok',
    'invalidValue',
    'invalidHandle',
    'wrongState',
    'invalidFile',
    'unsupported',
    'io',
    'outOfMemory',
    'other',
];

// A value from the user on one short line.
export function shown(value) {
    if (typeof value === 'string') return JSON.stringify(value.length > 60 ? value.slice(0, 60) + '…' : value);
    if (Array.isArray(value) || ArrayBuffer.isView(value))
        return `${value.constructor.name} of ${value.length ?? value.byteLength}`;
    if (typeof value === 'object' && value !== null) return value.constructor?.name ?? 'object';
    if (typeof value === 'function') return 'function';
    return typeof value === 'bigint' ? `${value}n` : String(value);
}

/**
 * Throws a CairnError: `field` has the value `value`, but must be as `expected` says. For `wrongState`, `value` is a
 * word that describes the state.
 * @returns {never}
 */
export function refuse(field, value, expected, code = 'invalidValue') {
    const text = code === 'wrongState' ? value : shown(value);
    throw new CairnError(code, `${field}: ${expected}, got ${text}`, field, text);
}

/** What a call that was refused throws. The world is as it was before the call. */
export class CairnError extends Error {
    /**
     * @param {string} code what kind of error, as `CairnErrorCode` in index.d.ts lists them
     * @param {string} message what was wrong, in words
     * @param {string} field the argument or member that it is about, such as `BodyDef.mass`; may be empty
     * @param {string} value what that was; may be empty
     */
    constructor(code, message, field = '', value = '') {
        super(message);
        this.name = 'CairnError';
        this.code = code;
        this.field = field;
        this.value = value;
    }
}

// In the order of the numbers of cairn_result.
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

// A value of the user's on one short line.
export function shown(value) {
    if (typeof value === 'string') return JSON.stringify(value.length > 60 ? value.slice(0, 60) + '…' : value);
    if (Array.isArray(value) || ArrayBuffer.isView(value))
        return `${value.constructor.name} of ${value.length ?? value.byteLength}`;
    if (typeof value === 'object' && value !== null) return value.constructor?.name ?? 'object';
    if (typeof value === 'function') return 'function';
    return typeof value === 'bigint' ? `${value}n` : String(value);
}

/**
 * Throws: `field` is `value`, and should be as `expected` says. Of a wrong state, `value` is a word for it.
 * @returns {never}
 */
export function refuse(field, value, expected, code = 'invalidValue') {
    const text = code === 'wrongState' ? value : shown(value);
    throw new CairnError(code, `${field}: ${expected}, got ${text}`, field, text);
}

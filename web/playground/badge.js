// The text of the badge: whether the run in this browser has the same bits as the reference run.
export function describe({ touched, compared, hashes }) {
    if (compared && compared.here !== compared.there) {
        return {
            state: 'different',
            html:
                `After ${compared.steps} steps this browser has <code>${compared.here}</code>, ` +
                `native code <code>${compared.there}</code>: not the same.`,
        };
    }
    const same =
        compared &&
        `After ${compared.steps} steps: this browser <code>${compared.here}</code> = ` +
            `native <code>${compared.there}</code>`;
    if (touched)
        return {
            state: 'waiting',
            html: `${same ? `${same}. ` : ''}Changed by hand, so that the state cannot be compared. Reset to compare.`,
        };
    if (same) return { state: 'same', html: same };
    const next = Object.keys(hashes)[0];
    return {
        state: 'waiting',
        html: next
            ? `The state is compared with that of native code after ${next} steps.`
            : 'No native run of this scene to compare with.',
    };
}

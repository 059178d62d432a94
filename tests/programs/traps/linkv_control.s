; The first instruction has no control vector.
        .include "bad_link.inc"
        MPYSV   [va], x, [from] ? [vz]
        ADDNV   [from], [va], [to]

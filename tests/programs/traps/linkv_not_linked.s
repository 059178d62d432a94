; The second instruction does not read what the first one makes.
        .include "bad_link.inc"
        MPYSV   [va], x, [from]
        ADDNV   [va], y, [to]

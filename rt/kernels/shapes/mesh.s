; mesh.s - the mesh, by hand in each form.
;
; Record: words per triangle row, room for crossings; with a body also: offset
;         of the body's table in this one, in words, and its room for
;         crossings.  Table: nodes and triangles (records.s).

        include_form mesh

lint.vlt
macram_ram.v
macram_lutram.v
macram_add3.v
macram_unit.v
macram_top.v

macram_top.v
macram_unit.v
macram_ram.v
macram_lutram.v
lint.vlt

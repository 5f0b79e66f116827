// Test design: a stream of 40 bits through one register, with faults on demand, and one memory.
module echo (
    input             aclk, aresetn,
    input      [2:0]  fault,  // 1 tvalid falls in a stall, 2 payload changes in a stall, 3 TLAST early, 4 missing
    input      [39:0] s_axis_tdata,
    input             s_axis_tvalid, s_axis_tlast,
    output            s_axis_tready,
    output     [39:0] m_axis_echo_tdata,
    output            m_axis_echo_tvalid, m_axis_echo_tlast,
    input             m_axis_echo_tready,
    output     [7:0]  word,
    output reg [31:0] unset
);
    reg [39:0] data;
    reg        valid, last;
    wire       stalled;
    echo_stall inner (.aclk(aclk), .stall(valid & !m_axis_echo_tready & aresetn), .stalled(stalled));
    reg [15:0] count;
    reg [7:0]  mem [0:3];
    initial $readmemh("echo.mem", mem);
    assign word = mem[2];
    assign s_axis_tready = aresetn & (!valid | m_axis_echo_tready);
    assign m_axis_echo_tvalid = valid & !(fault == 1 & stalled);
    assign m_axis_echo_tdata = fault == 2 & stalled & count > 20 ? ~data : data;
    assign m_axis_echo_tlast = fault == 3 & count == 7 ? 1'b1 : fault == 4 ? 1'b0 : last;
    always @(posedge aclk) begin
        if (count == 16'hffff) unset <= 0;
        if (s_axis_tready) begin
            valid <= s_axis_tvalid;
            data <= s_axis_tdata;
            last <= s_axis_tlast;
        end
        if (m_axis_echo_tvalid & m_axis_echo_tready) count <= count + 1;
        if (!aresetn) begin
            valid <= 0;
            count <= 0;
        end
    end
endmodule

module echo_stall (input aclk, input stall, output stalled);
    reg hidden;
    assign stalled = hidden;
    always @(posedge aclk) hidden <= stall;
endmodule

% Writes the deck of a dry-stone tower on a base that begins to move.
n  = 4;      % number of blocks
w  = 0.4;    % width of a block, m
h  = 0.25;   % height of a block, m
v0 = 0.5;    % velocity of the base, m/s
tend = 0.4;  % end of the run, s
dt = 5e-6;   % time step, s

E = 10e9; nu = 0.2; rho = 2400;            % stone
lambda = E*nu / ((1+nu)*(1-2*nu));
mu = E / (2*(1+nu));

% nodes and elements: 5 nodes and 4 triangles for each block, the base is block 0
xy = zeros(0,2); elements = zeros(0,3); property = []; set = [];
for k = 0:n
    b = w; x0 = 0; y0 = (k-1)*h;
    if k == 0, b = 3*w; x0 = -w; end       % the base is wider
    first = size(xy,1);                    % numbers begin at 0
    xy = [xy; x0 y0; x0+b y0; x0+b y0+h; x0 y0+h; x0+b/2 y0+h/2];
    for e = 0:3                            % counter-clockwise
        elements(end+1,:) = first + [e, mod(e+1,4), 4];
        property(end+1) = 0;
    end
    set = [set, (k==0)*ones(1,5)];         % node set 1 is the base
end
nn = size(xy,1); ne = size(elements,1);

f = fopen('tower.y', 'w');
fprintf(f, '/* Tower of %d blocks on a moving base, made by tower.m */\n', n);
% control; %d, not %g: 1e+06 is no integer to the reader
fprintf(f, '/YD/YDC/MCSTEP %d\n', round(tend/dt) + 1);
fprintf(f, '/YD/YDC/DCSTEC %.17g\n', dt);
fprintf(f, '/YD/YDC/DCGRAY -9.81\n');
fprintf(f, '/YD/YDC/ICOUTF 2000\n/YD/YDC/ICSHTF 5000\n');
% nodes
fprintf(f, '/YD/YDN/MNODIM 2\n/YD/YDN/NNODIM 2\n/YD/YDN/MNOPO %d\n/YD/YDN/NNOPO %d\n', nn, nn);
fprintf(f, '/YD/YDN/D2NCI 21 2 %d\n', nn);  fprintf(f, '%.17g %.17g\n', xy');
fprintf(f, '/YD/YDN/D2NCC 21 2 %d\n', nn);  fprintf(f, '%.17g %.17g\n', xy');
fprintf(f, '/YD/YDN/D2NVC 21 2 %d\n', nn); fprintf(f, repmat('0 0\n', 1, nn));
fprintf(f, '/YD/YDN/I1NOBF %d\n', nn);      fprintf(f, '%d ', ones(1,nn)); fprintf(f, '\n');
fprintf(f, '/YD/YDN/I1NOPR %d\n', nn);      fprintf(f, '%d ', set); fprintf(f, '\n');
% elements
fprintf(f, '/YD/YDE/MELEM %d\n/YD/YDE/NELEM %d\n/YD/YDE/MELST 1\n/YD/YDE/NELST 1\n', ne, ne);
fprintf(f, '/YD/YDE/MELNO 4\n/YD/YDE/NELNO 3\n');
fprintf(f, '/YD/YDE/I1ELPR %d\n', ne);      fprintf(f, '%d ', property); fprintf(f, '\n');
fprintf(f, '/YD/YDE/I2ELTO 21 3 %d\n', ne); fprintf(f, '%d %d %d\n', elements');
% contact
fprintf(f, '/YD/YDI/MICOUP 2000\n/YD/YDI/MISTATE 6\n/YD/YDI/DIEZON %.17g\n/YD/YDI/DIEDI 200\n', h/10);
% material: penalties are a multiple of the stiffness
fprintf(f, '/YD/YDPE/MPROP 1\n/YD/YDPE/NPROP 1\n/YD/YDPE/I1PTYP 1 1\n');
fprintf(f, '/YD/YDPE/D1PELA 1 %.17g\n/YD/YDPE/D1PEMU 1 %.17g\n/YD/YDPE/D1PERO 1 %.17g\n', lambda, mu, rho);
fprintf(f, '/YD/YDPE/D1PEKS 1 %.17g\n', 0.2*2*h*sqrt(E*rho));
fprintf(f, '/YD/YDPE/D1PEPE 1 %.17g\n/YD/YDPE/D1PEPT 1 %.17g\n', 10*E, E);
fprintf(f, '/YD/YDPE/D1PEFR 1 0.6\n/YD/YDPE/D1PSEM 1 0\n');
% node sets: 0 the blocks (free), 1 the base (velocity given)
fprintf(f, '/YD/YDPN/MPNSET 2\n/YD/YDPN/NPNSET 2\n/YD/YDPN/MPNFACT 4\n/YD/YDPN/NPNFACT 4\n');
fprintf(f, '/YD/YDPN/D3PNFAC 231 2 2 4\n');
fprintf(f, '0 1  0.1 1  0.15 1  %.17g 1\n', 2*tend);
fprintf(f, '0 0  0.1 0  0.15 1  %.17g 1\n', 2*tend);
fprintf(f, '/YD/YDPN/I1PNFX 2 1 3\n/YD/YDPN/I1PNFY 2 1 3\n');
fprintf(f, '/YD/YDPN/D1PNAX 2 0 %.17g\n/YD/YDPN/D1PNAY 2 0 0\n', v0);
% histories: kinetic energy, and the speed in the top block
fprintf(f, '/YD/YDO/MOHYS 2\n/YD/YDO/NOHYS 2\n/YD/YDO/DOHYP 0\n/YD/YDO/I1OHYT 2 15 8\n');
fprintf(f, '/YD/YDO/D1OHYC 2 1 1\n/YD/YDO/D1OHYF 2 1 1\n');
fprintf(f, '/YD/YDO/D1OHYX 2 0 %.17g\n/YD/YDO/D1OHYY 2 0 %.17g\n', w/2+0.01, (n-1)*h+0.05);
fprintf(f, '$YDOIT\n$YSTOP\n');
fclose(f);

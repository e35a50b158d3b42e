// Shows the scene of space that the page carries: turns with the mouse, names what lies under it.
(function () {
  "use strict";
  const data = JSON.parse(document.getElementById("scene").textContent);
  const canvas = document.getElementById("picture");
  const tip = document.getElementById("tip");
  const peels = 8; // layers of translucent surfaces that are put in their order

  function bytes(text) {
    return Uint8Array.from(atob(text), function (c) { return c.charCodeAt(0); }).buffer;
  }
  function vector(p) {
    return new THREE.Vector3(p[0], p[1], p[2]);
  }

  let renderer;
  try {
    renderer = new THREE.WebGLRenderer({canvas: canvas, preserveDrawingBuffer: true});
  } catch (error) {
    document.getElementById("trouble").textContent = "This picture needs WebGL, which this browser does not give.";
    return;
  }
  renderer.autoClear = false;
  const canPeel = Boolean(renderer.extensions.get("WEBGL_depth_texture") || renderer.capabilities.isWebGL2);

  // --- materials ------------------------------------------------------------------------------------------------------

  const nothing = new THREE.Texture();
  const peeling = {
    pass: {value: -1}, // -1: opaque things; 0 and more: the layers of translucent ones
    opaqueDepth: {value: nothing},
    peeledDepth: {value: nothing},
    resolution: {value: new THREE.Vector2(1, 1)}
  };

  const surfaceVertex = `
    attribute vec3 tint;
    varying vec3 turned, tinted;
    void main() {
      turned = normalMatrix * normal;
      tinted = tint;
      gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    }`;
  const surfaceFragment = `
    uniform vec3 color;
    uniform float opacity, ambient, pass;
    uniform sampler2D opaqueDepth, peeledDepth;
    uniform vec2 resolution;
    varying vec3 turned, tinted;
    void main() {
      vec2 here = gl_FragCoord.xy / resolution;
      if (pass >= 0.0 && gl_FragCoord.z > texture2D(opaqueDepth, here).r) discard;
      if (pass >= 1.0 && gl_FragCoord.z <= texture2D(peeledDepth, here).r + 2e-6) discard;
      float light = abs(dot(normalize(turned), normalize(vec3(0.25, 0.5, 0.85))));
      gl_FragColor = vec4(color * tinted * (ambient + (1.0 - ambient) * (0.3 + 0.7 * light)), opacity);
    }`;
  // A line is a ribbon as wide as it is asked for, turned to the eye and a little before the surfaces it borders.
  const lineVertex = `
    attribute vec3 other;
    attribute float side;
    uniform vec2 resolution;
    uniform float width;
    void main() {
      vec4 a = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      vec4 b = projectionMatrix * modelViewMatrix * vec4(other, 1.0);
      vec2 way = (b.xy / b.w - a.xy / a.w) * resolution;
      way = length(way) > 0.0 ? normalize(way) : vec2(1.0, 0.0);
      a.xy += side * width * vec2(-way.y, way.x) / resolution * a.w;
      a.z -= 2e-4 * a.w;
      gl_Position = a;
    }`;
  const lineFragment = `
    uniform vec3 color;
    uniform float opacity;
    void main() { gl_FragColor = vec4(color, opacity); }`;

  function surfaceMaterial(item) {
    return new THREE.ShaderMaterial({
      uniforms: Object.assign({
        color: {value: vector(item.colors ? [1, 1, 1] : item.color)}, opacity: {value: item.opacity}, ambient: {value: item.ambient}
      }, peeling),
      vertexShader: surfaceVertex, fragmentShader: surfaceFragment, side: THREE.DoubleSide,
      blending: THREE.NoBlending, polygonOffset: item.opacity === 1, polygonOffsetFactor: 1, polygonOffsetUnits: 1
    });
  }
  function lineMaterial(item) {
    return new THREE.ShaderMaterial({
      uniforms: {
        color: {value: vector(item.color)}, opacity: {value: item.opacity}, width: {value: 1},
        resolution: peeling.resolution
      },
      vertexShader: lineVertex, fragmentShader: lineFragment, side: THREE.DoubleSide, transparent: true
    });
  }

  // --- geometry -------------------------------------------------------------------------------------------------------

  // Every triangle has corners of its own, so that facets stay flat.
  // Colours of the points are levels from 0 to 255; without any the item's own is enough.
  function surfaceGeometry(positions, faces, colors) {
    const corners = new Float32Array(3 * faces.length);
    faces.forEach(function (point, i) { corners.set(positions.subarray(3 * point, 3 * point + 3), 3 * i); });
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(corners, 3));
    const tints = new Float32Array(3 * faces.length).fill(1);
    if (colors.length) {
      faces.forEach(function (point, i) {
        for (let k = 0; k < 3; ++k) tints[3 * i + k] = colors[3 * point + k] / 255;
      });
    }
    geometry.setAttribute("tint", new THREE.BufferAttribute(tints, 3));
    geometry.computeVertexNormals();
    return geometry;
  }
  function lineGeometry(positions, lines) {
    const here = [], other = [], side = [], index = [];
    for (let i = 0; i < lines.length; i += 2) {
      const a = positions.subarray(3 * lines[i], 3 * lines[i] + 3);
      const b = positions.subarray(3 * lines[i + 1], 3 * lines[i + 1] + 3);
      const first = here.length / 3;
      here.push(...a, ...a, ...b, ...b);
      other.push(...b, ...b, ...a, ...a);
      side.push(1, -1, -1, 1);
      index.push(first, first + 1, first + 2, first + 2, first + 1, first + 3);
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.Float32BufferAttribute(here, 3));
    geometry.setAttribute("other", new THREE.Float32BufferAttribute(other, 3));
    geometry.setAttribute("side", new THREE.Float32BufferAttribute(side, 1));
    geometry.setIndex(index);
    return geometry;
  }

  const opaque = new THREE.Scene();
  const translucent = new THREE.Scene();
  const meshes = [];
  data.items.forEach(function (item) {
    const positions = new Float32Array(bytes(item.positions));
    const faces = new Uint32Array(bytes(item.faces));
    const lines = new Uint32Array(bytes(item.lines));
    const colors = new Uint8Array(bytes(item.colors));
    const isSurface = faces.length > 0;
    const mesh = isSurface ? new THREE.Mesh(surfaceGeometry(positions, faces, colors), surfaceMaterial(item))
                           : new THREE.Mesh(lineGeometry(positions, lines), lineMaterial(item));
    mesh.frustumCulled = false;
    mesh.userData = {item: item, isSurface: isSurface, cells: new Uint32Array(bytes(item.cells))};
    mesh.renderOrder = isSurface ? 0 : 1;
    meshes.push(mesh);
    (isSurface && item.opacity < 1 ? translucent : opaque).add(mesh);
  });

  // --- camera ---------------------------------------------------------------------------------------------------------

  const camera = new THREE.PerspectiveCamera(data.view.angle, 1, 1, 10);
  const start = vector(data.view.position);
  const focus = vector(data.view.focus);
  camera.up.copy(vector(data.view.axis)); // the axis about which a drag turns
  // Seen along the axis, what is up on the screen is told by a place a little aside.
  if (start.clone().sub(focus).cross(camera.up).length() < 1e-3 * start.distanceTo(focus)) {
    start.addScaledVector(vector(data.view.up), -1e-3 * start.distanceTo(focus));
  }
  camera.position.copy(start);
  const controls = new THREE.OrbitControls(camera, canvas);
  controls.enableKeys = false; // they would move, and know no other key
  controls.target.copy(focus);
  controls.update();

  function reset() {
    controls.target.copy(focus);
    camera.position.copy(start);
    controls.update();
    draw();
  }
  function turn(right, up) {
    const step = Math.PI / 36;
    const away = camera.position.clone().sub(controls.target);
    const axis = camera.up.clone().normalize();
    const aside = axis.clone().cross(away).normalize();
    const slope = away.angleTo(axis) - up * step;
    if (slope > 0.01 && slope < Math.PI - 0.01) away.applyAxisAngle(aside, -up * step);
    camera.position.copy(controls.target).add(away.applyAxisAngle(axis, right * step));
    controls.update();
  }
  function zoom(factor) {
    camera.position.sub(controls.target).divideScalar(factor).add(controls.target);
    controls.update();
  }

  function isBehind(front) {
    return camera.position.clone().sub(vector(front.origin)).dot(vector(front.normal)) <= 0;
  }
  // The place of what stands in the upper right corner, whatever is seen.
  function corner(down) {
    const height = canvas.clientHeight, width = canvas.clientWidth;
    const depth = new THREE.Vector3(0, 0, -1.5 * camera.near).applyMatrix4(camera.projectionMatrix).z;
    return new THREE.Vector3(1 - 0.2 * height / width, 1 - 2 * down, depth).unproject(camera);
  }
  function place(mesh) {
    const item = mesh.userData.item;
    const behind = Boolean(item.front) && isBehind(item.front);
    mesh.visible = panel.isOn(item.layer, item.light) && !(behind && mesh.userData.isSurface);
    if (!mesh.userData.isSurface) mesh.material.uniforms.opacity.value = behind ? 0.35 : item.opacity;
    if (!item.corner) return;
    mesh.position.copy(corner(0.1));
    mesh.scale.setScalar(0.12 * 2 * Math.tan(Math.PI / 360 * data.view.angle) * 1.5 * camera.near);
    mesh.updateMatrixWorld();
  }

  // --- drawing --------------------------------------------------------------------------------------------------------

  const screenCamera = new THREE.OrthographicCamera(-1, 1, 1, -1, 0, 1);
  function screen(fragment, uniforms, blending) {
    const scene = new THREE.Scene();
    const material = new THREE.ShaderMaterial(Object.assign({
      uniforms: uniforms, depthTest: false, depthWrite: false, transparent: true,
      vertexShader: "varying vec2 at; void main() { at = uv; gl_Position = vec4(position.xy, 0.0, 1.0); }",
      fragmentShader: "varying vec2 at; uniform sampler2D image; void main() { " + fragment + " }"
    }, blending));
    const mesh = new THREE.Mesh(new THREE.PlaneBufferGeometry(2, 2), material);
    mesh.frustumCulled = false;
    scene.add(mesh);
    return scene;
  }
  const shown = {value: nothing};
  const copy = screen("gl_FragColor = texture2D(image, at);", {image: shown}, {blending: THREE.NoBlending});
  // Below what is there already: front to back, colours multiplied by their opacity.
  const under = screen("vec4 c = texture2D(image, at); gl_FragColor = vec4(c.rgb * c.a, c.a);", {image: shown}, {
    blending: THREE.CustomBlending, blendEquation: THREE.AddEquation,
    blendSrc: THREE.OneMinusDstAlphaFactor, blendDst: THREE.OneFactor
  });
  const over = screen("gl_FragColor = texture2D(image, at);", {image: shown}, {
    blending: THREE.CustomBlending, blendEquation: THREE.AddEquation,
    blendSrc: THREE.OneFactor, blendDst: THREE.OneMinusSrcAlphaFactor
  });

  let targets = [];
  function newTarget(width, height) {
    const target = new THREE.WebGLRenderTarget(width, height, {
      minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter
    });
    target.depthTexture = new THREE.DepthTexture(width, height, THREE.UnsignedIntType);
    return target;
  }
  // A texture that is drawn into must not be read from, not even by name: WebGL then draws nothing.
  function unbind() {
    peeling.opaqueDepth.value = peeling.peeledDepth.value = shown.value = nothing;
  }
  function resize() {
    const width = Math.max(1, canvas.clientWidth), height = Math.max(1, canvas.clientHeight);
    unbind();
    renderer.setPixelRatio(Math.max(2, window.devicePixelRatio || 1)); // averaged by the browser: smooth edges
    renderer.setSize(width, height, false);
    renderer.getDrawingBufferSize(peeling.resolution.value);
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
    targets.forEach(function (target) { target.depthTexture.dispose(); target.dispose(); });
    const size = peeling.resolution.value;
    targets = canPeel ? [0, 1, 2, 3].map(function () { return newTarget(size.x, size.y); }) : [];
  }
  function clear(target, alpha) {
    renderer.setRenderTarget(target);
    renderer.setClearColor(0xffffff, alpha);
    if (alpha === 0) renderer.setClearColor(0x000000, 0);
    renderer.clear();
  }
  function drawPeeled() {
    const solid = targets[0], sum = targets[1], layers = [targets[2], targets[3]];
    peeling.pass.value = -1;
    unbind();
    clear(solid, 1);
    renderer.render(opaque, camera);
    clear(sum, 0);
    peeling.opaqueDepth.value = solid.depthTexture;
    for (let i = 0; i < peels; ++i) {
      peeling.pass.value = i;
      peeling.peeledDepth.value = layers[(i + 1) % 2].depthTexture;
      clear(layers[i % 2], 0);
      renderer.render(translucent, camera);
      shown.value = layers[i % 2].texture;
      renderer.setRenderTarget(sum);
      renderer.render(under, screenCamera);
    }
    clear(null, 1);
    shown.value = solid.texture;
    renderer.render(copy, screenCamera);
    shown.value = sum.texture;
    renderer.render(over, screenCamera);
  }
  function drawSorted() {
    peeling.pass.value = -1;
    clear(null, 1);
    renderer.render(opaque, camera);
    translucent.traverse(function (mesh) {
      if (mesh.material) Object.assign(mesh.material, {blending: THREE.NormalBlending, transparent: true, depthWrite: false});
    });
    renderer.render(translucent, camera);
  }
  function draw() {
    document.documentElement.removeAttribute("data-drawn");
    camera.updateMatrixWorld();
    const away = camera.position.distanceTo(controls.target);
    camera.near = Math.max(0.02 * away, away - 3 * data.size);
    camera.far = away + 4 * data.size;
    camera.updateProjectionMatrix();
    const ratio = renderer.getPixelRatio();
    meshes.forEach(function (mesh) {
      place(mesh);
      if (!mesh.userData.isSurface) mesh.material.uniforms.width.value = ratio * mesh.userData.item.width;
    });
    canPeel ? drawPeeled() : drawSorted();
    placeLabels();
    clearTimeout(resting);
    resting = setTimeout(rest, 100);
  }
  // What takes a moment waits until the picture rests.
  let resting = 0;
  function rest() {
    findAnchors();
    placeLabels();
    document.documentElement.setAttribute("data-drawn", "yes");
  }

  // --- words ----------------------------------------------------------------------------------------------------------

  const raycaster = new THREE.Raycaster();
  const leaders = document.getElementById("leaders");
  const labels = data.labels.map(function (label) {
    const element = document.createElement("div");
    element.className = "label";
    element.textContent = label.text;
    document.body.appendChild(element);
    const leader = document.createElementNS(leaders.namespaceURI, "line");
    leaders.appendChild(leader);
    return {element: element, leader: leader, data: label, places: label.places.map(vector), at: null,
            width: element.offsetWidth, height: element.offsetHeight};
  });
  // A place is seen if nothing opaque stands before it.
  function isSeen(place, before) {
    const way = place.clone().sub(camera.position);
    raycaster.set(camera.position, way.clone().normalize());
    raycaster.far = way.length() - 2e-3 * data.size;
    return raycaster.intersectObjects(before).length === 0;
  }
  // Each name stands on its own element, at the first place of it that is seen.
  function findAnchors() {
    const before = meshes.filter(function (mesh) {
      return mesh.visible && mesh.userData.isSurface && mesh.userData.item.opacity === 1 && !mesh.userData.item.corner;
    });
    labels.forEach(function (label) {
      label.at = label.places.find(function (place) { return isSeen(place, before); }) || null;
    });
    raycaster.far = Infinity;
  }
  function inPixels(place) {
    const p = place.clone().project(camera);
    if (p.z >= 1) return null;
    return {x: (p.x + 1) / 2 * canvas.clientWidth, y: (1 - p.y) / 2 * canvas.clientHeight};
  }
  // What overlaps is pushed apart along the shorter way; what still does then is left out.
  function pushApart(boxes, width, height) {
    function overlap(a, b) {
      const x = (a.width + b.width) / 2 - Math.abs(a.x - b.x), y = (a.height + b.height) / 2 - Math.abs(a.y - b.y);
      return x > 0.01 && y > 0.01 ? {x: x, y: y} : null;
    }
    for (let round = 0, moved = true; moved && round < 100; ++round) {
      moved = false;
      boxes.forEach(function (a, i) {
        boxes.slice(i + 1).forEach(function (b) {
          const both = overlap(a, b);
          if (!both) return;
          const way = both.y <= both.x ? "y" : "x";
          const half = (both[way] + 0.1) / 2 * (a[way] <= b[way] ? -1 : 1);
          a[way] += half;
          b[way] -= half;
          moved = true;
        });
      });
      boxes.forEach(function (box) {
        box.x = Math.max(box.width / 2, Math.min(width - box.width / 2, box.x));
        box.y = Math.max(box.height / 2, Math.min(height - box.height / 2, box.y));
      });
    }
    return boxes.filter(function (a, i) {
      return !boxes.slice(0, i).some(function (b) { return overlap(a, b); });
    });
  }
  function labelBox(label) {
    const use = label.data;
    if (!panel.isOn(use.layer, use.light) || (use.front && isBehind(use.front))) return null;
    const at = use.corner ? inPixels(corner(0.19)) : label.at && inPixels(label.at);
    return at && {x: at.x, y: at.y, from: at, width: label.width, height: label.height, label: label};
  }
  function placeLabels() {
    labels.forEach(function (label) { label.element.style.display = label.leader.style.display = "none"; });
    const inside = labels.map(labelBox).filter(function (box) {
      return box && box.x >= 0 && box.x <= canvas.clientWidth && box.y >= 0 && box.y <= canvas.clientHeight;
    });
    pushApart(inside, canvas.clientWidth, canvas.clientHeight).forEach(function (box) {
      const element = box.label.element, leader = box.label.leader;
      element.style.left = box.x + "px";
      element.style.top = box.y + "px";
      element.style.display = "block";
      if (Math.abs(box.y - box.from.y) < box.height / 2 && Math.abs(box.x - box.from.x) < box.width / 2) return;
      [["x1", box.from.x], ["y1", box.from.y], ["x2", box.x], ["y2", box.y]].forEach(function (end) {
        leader.setAttribute(end[0], end[1]);
      });
      leader.style.display = "inline";
    });
  }

  function nameOf(hit) {
    const use = hit.object.userData;
    const plane = use.cells.length ? use.item.names[use.cells[hit.faceIndex]] : "";
    return plane ? use.item.name + ": " + plane : use.item.name;
  }
  function point(event) {
    const box = canvas.getBoundingClientRect();
    const at = new THREE.Vector2(2 * (event.clientX - box.left) / box.width - 1,
                                 1 - 2 * (event.clientY - box.top) / box.height);
    raycaster.setFromCamera(at, camera);
    const candidates = meshes.filter(function (mesh) {
      return mesh.visible && mesh.userData.isSurface && mesh.userData.item.name;
    });
    const names = [];
    for (const hit of raycaster.intersectObjects(candidates)) {
      const name = nameOf(hit);
      if (names.indexOf(name) < 0) names.push(name);
      if (hit.object.userData.item.opacity === 1 || names.length === 6) break;
    }
    tip.textContent = names.join("\n");
    tip.style.display = names.length ? "block" : "none";
    tip.style.left = Math.min(event.clientX + 14, canvas.clientWidth - tip.offsetWidth - 8) + "px";
    tip.style.top = Math.min(event.clientY + 14, canvas.clientHeight - tip.offsetHeight - 8) + "px";
  }

  const panel = gnomonPanel(data, {changed: draw, reset: reset, turn: turn, zoom: zoom});
  controls.addEventListener("change", draw);
  canvas.addEventListener("mousemove", point);
  canvas.addEventListener("mouseleave", function () { tip.style.display = "none"; });
  window.addEventListener("resize", function () { resize(); draw(); });
  resize();
  draw();
})();

export {BufferAttribute, BufferGeometry, CanvasTexture, Color, DirectionalLight, DoubleSide, Float32BufferAttribute, Group, HemisphereLight, Line, LineBasicMaterial, LineSegments, Mesh, MeshBasicMaterial, MeshLambertMaterial, OrthographicCamera, PerspectiveCamera, Points, PointsMaterial, Scene, ShapeUtils, Vector2, Vector3, WebGLRenderer} from "three";
export {Line2} from "three/examples/jsm/lines/Line2.js";
export {LineGeometry} from "three/examples/jsm/lines/LineGeometry.js";
export {LineMaterial} from "three/examples/jsm/lines/LineMaterial.js";
export {OrbitControls} from "three/examples/jsm/controls/OrbitControls.js";
